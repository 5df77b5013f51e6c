package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.route.PathTask;
import org.dronewatch.route.ResponseTime;
import org.dronewatch.route.Sensing;
import org.dronewatch.route.TimelyDetection;
import org.dronewatch.sensor.Chance;

/**
 * The times at which a flight may raise its alert, and the probability of each.
 *
 * @param times times of the looks, ascending, s
 * @param probabilities probability that the alert is raised at each of these times
 */
record AlertChances(List<Double> times, List<Double> probabilities) {
    AlertChances {
        times = List.copyOf(times);
        probabilities = List.copyOf(probabilities);
    }

    /**
     * The chances by the rule of a scene, where they can be computed: if any sensor alone raises an alert, by its first
     * detection or, where its looks are independent, by detections in several of up to twelve looks. Empty for other
     * rules.
     *
     * @param wait whether observers see the drone while it waits
     */
    static Optional<AlertChances> of(LookSchedule schedule, AlertSettings alert, MissedLooks.Wait wait) {
        return isKnown(schedule, alert) ? Optional.of(ofAnySensor(schedule, alert, wait)) : Optional.empty();
    }

    /** Whether they can be computed. */
    static boolean isKnown(LookSchedule schedule, AlertSettings alert) {
        int looks = alert.confirm().looks();
        boolean isIndependent = schedule.sensors().stream().allMatch(sensor -> sensor.chance() == Chance.PER_LOOK);
        return alert.rule() instanceof AlertRule.AnySensor
                && (looks == 1 || isIndependent && looks <= ConfirmedMisses.MOST_LOOKS);
    }

    /** The probability that an alert is raised at or before a time, s since the start of the run. */
    double by(double time) {
        return IntStream.range(0, times.size())
                .filter(i -> times.get(i) <= time)
                .mapToDouble(probabilities::get)
                .sum();
    }

    /**
     * The probability that an alert is raised in time: what is left of the flight after it is one task.
     *
     * @param end end of the flight, s since the start of the run
     */
    double inTime(double end, ResponseTime response) {
        return IntStream.range(0, times.size())
                .mapToDouble(i -> {
                    double left = end - times.get(i);
                    List<PathTask> tasks =
                            List.of(new PathTask(1.0, 0.0, 0.0), new PathTask(0.0, left, FlownRoute.SPREAD * left));
                    return probabilities.get(i) * new TimelyDetection(tasks, Sensing.END, 1.0, response).interruption();
                })
                .sum();
    }

    private static AlertChances ofAnySensor(LookSchedule schedule, AlertSettings alert, MissedLooks.Wait wait) {
        List<ConfirmedMisses> confirmed = schedule.sensors().stream()
                .map(sensor -> new ConfirmedMisses(alert.confirm()))
                .toList();
        double[] undetected = schedule.missedAfterEach(wait);
        double[] missed = new double[schedule.sensors().size()];
        Arrays.fill(missed, 1.0);
        List<Double> times = new ArrayList<>();
        List<Double> probabilities = new ArrayList<>();
        double before = 1.0;
        for (int i = 0; i < undetected.length; i++) {
            ScheduledLook look = schedule.looks().get(i);
            int sensor = look.number();
            missed[sensor] = schedule.sensors().get(sensor).chance() == Chance.PER_LOOK
                    ? confirmed.get(sensor).after(look.probability())
                    : undetected[i];
            double now = Arrays.stream(missed).reduce(1.0, (one, other) -> one * other);
            if (now < before) {
                times.add(look.time());
                probabilities.add(before - now);
                before = now;
            }
        }
        return new AlertChances(times, probabilities);
    }
}
