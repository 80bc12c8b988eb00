#include "view/recorder.hpp"

#include "export/cast.hpp"

namespace carom {
namespace {

constexpr const char* kHideCursor = "\x1B[?25l";

}  // namespace

Recorder::Recorder(const std::string& option, const std::string& file, Palette palette)
    : name_(file), file_(option, file), encoder_(palette) {}

void Recorder::picture(Instant now, const Canvas& canvas, const std::string& title) {
  std::string bytes;
  if (!begun_) {
    begun_ = now;
    file_.write(CastText(canvas.columns, canvas.rows, title).header());
    bytes = kHideCursor;
  } else if (canvas.columns != size_.columns || canvas.rows != size_.rows) {
    file_.write(CastText::resize(seconds(now), canvas.columns, canvas.rows));
  }
  size_ = {canvas.columns, canvas.rows};
  bytes += encoder_.show(canvas);
  file_.write(CastText::output(seconds(now), bytes));
}

void Recorder::finish(Instant now) {
  file_.write(CastText::output(begun_ ? seconds(now) : 0, PictureChanges::end()));
  file_.commit();
}

double Recorder::seconds(Instant now) const {
  return std::chrono::duration<double>(now - *begun_).count();
}

}  // namespace carom
