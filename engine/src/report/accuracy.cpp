#include "carom/accuracy.hpp"

#include "carom/report.hpp"
#include "json/writer.hpp"

namespace carom {
namespace {

using json::Writer;

constexpr auto kLines = Writer::Layout::lines;

void put_observable(Writer& writer, const std::optional<MeanAndError>& mean,
                    const std::optional<MeanAndError>* reference) {
  if (!mean) {
    writer.null();
    return;
  }
  writer.begin_object().put("mean", mean->mean).put("standard_error", mean->standard_error);
  if (reference != nullptr) {
    writer.key("difference");
    if (*reference) {
      writer.value(mean->mean - (*reference)->mean);
    } else {
      writer.null();
    }
  }
  writer.end_object();
}

class StudyWriter {
 public:
  StudyWriter(const AccuracyStudy& study, const TextSink& sink) : study_(study), writer_(sink) {}

  void write() {
    writer_.begin_object(kLines)
        .put("version", version())
        .put("scene", study_.scene)
        .put("time", study_.time)
        .put("balls", study_.balls)
        .put("smallest_radius", study_.smallest_radius)
        .put("seed", study_.seed);
    writer_.key("machine")
        .begin_object()
        .put("processor", study_.machine.processor)
        .put("cores", study_.machine.cores)
        .put("system", study_.machine.system)
        .end_object();
    writer_.put("compiler", study_.machine.compiler).put("starts", study_.starts);
    put_reference();
    writer_.key("rows").begin_list(kLines);
    for (const AccuracyRow& row : study_.rows) put_row(row);
    writer_.end_list();
    writer_.key("ladder_end");
    if (study_.sequence_end.empty()) {
      writer_.null();
    } else {
      writer_.value(study_.sequence_end);
    }
    writer_.put("target", study_.target).key("recommended");
    if (study_.recommended) {
      put_row(study_.rows[*study_.recommended]);
    } else {
      writer_.null();
    }
    writer_.end_object().finish();
  }

 private:
  void put_reference() {
    const AccuracyReference& reference = study_.reference;
    writer_.key("reference").begin_object(kLines).key("method");
    if (reference.absent.empty()) {
      writer_.value(reference.equilibrium ? "equilibrium" : method_name(reference.method));
      writer_.put("digits", reference.digits)
          .put("step", reference.step)
          .put("checked_digits", reference.checked_digits)
          .put("checked_step", reference.checked_step)
          .put("difference", reference.difference)
          .put("holds_until", reference.holds_until)
          .put("seconds", reference.seconds)
          .put("ball_ball", reference.ball_ball)
          .put("ball_wall", reference.ball_wall);
    } else {
      writer_.null().put("absent", reference.absent);
    }
    if (!study_.observables.empty()) {
      writer_.key("observables").begin_object(kLines);
      for (std::size_t i = 0; i < study_.averages.size(); ++i) {
        writer_.key(observable_name(study_.observables[i]));
        put_observable(writer_, study_.averages[i], nullptr);
      }
      writer_.end_object().put("observables_digits", study_.average_digits);
    }
    writer_.end_object();
  }

  void put_row(const AccuracyRow& row) {
    writer_.begin_object(kLines)
        .put("method", method_name(row.method))
        .put("step", row.step)
        .put("digits", row.digits)
        .put("workers", row.workers)
        .put("per_ball", row.per_ball);
    const bool failed = !row.failure.empty();
    const auto put = [&](const char* name, const auto& value) {
      writer_.key(name);
      if (failed) {
        writer_.null();
      } else {
        writer_.value(value);
      }
    };
    put("seconds", row.seconds);
    put("seconds_fastest", row.fastest);
    put("seconds_slowest", row.slowest);
    writer_.key("seconds_quartiles");
    if (failed) {
      writer_.null();
    } else {
      writer_.begin_list().value(row.quartiles[0]).value(row.quartiles[1]).end_list();
    }
    put("cpu_seconds", row.cpu_seconds);
    put("repeats", row.repeats);
    put("seconds_per_simulated_second", study_.seconds_per_simulated_second(row));
    put("position_error", row.position_error);
    put("energy_error", row.energy_error);
    put("max_overlap", row.max_overlap);
    put("ball_ball", row.ball_ball);
    put("ball_wall", row.ball_wall);
    put("horizon", row.horizon);
    put("horizon_resolution",
        row.horizon ? std::optional<double>(row.horizon_resolution) : std::nullopt);
    if (row.rest) put_rest(*row.rest);
    if (!study_.observables.empty()) put_averages(row);
    if (failed) writer_.put("failed", row.failure);
    writer_.end_object();
  }

  /// The members of a run that should come to rest; null in all others.
  void put_rest(const AccuracyRest& rest) {
    const auto put = [&](const std::string& name, const std::optional<MedianAndSpread>& value) {
      writer_.put(name, value ? std::optional<double>(value->median) : std::nullopt);
      writer_.put(name + "_spread", value ? std::optional<double>(value->spread) : std::nullopt);
    };
    put("equilibrium_residual", rest.equilibrium_residual);
    put("creep", rest.creep);
    put("kinetic_energy", rest.kinetic_energy);
    put("rest_time", rest.rest_time);
    put("dissipation_error", rest.dissipation_error);
    put("height", rest.height);
  }

  /// The averages of a row beside those of the reference.
  void put_averages(const AccuracyRow& row) {
    writer_.key("observables").begin_object(kLines);
    for (std::size_t i = 0; i < study_.observables.size(); ++i) {
      writer_.key(observable_name(study_.observables[i]));
      if (i < row.averages.size()) {
        put_observable(writer_, row.averages[i], &study_.averages[i]);
      } else {
        writer_.null();
      }
    }
    writer_.end_object();
  }

  const AccuracyStudy& study_;
  Writer writer_;
};

}  // namespace

std::string to_json(const AccuracyStudy& study) {
  std::string text;
  StudyWriter(study, [&](std::string_view part) { text += part; }).write();
  return text;
}

}  // namespace carom
