package org.dronewatch.report.html.run;

import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;

/**
 * Ranks runs by how well the site was warned. Only attacking drones count; if none attacks, all do.
 *
 * @param late number of drones whose alert was not in time, if a response time is required
 * @param missed number of drones without an alert
 * @param warning the shortest warning time, s; infinite if nothing is protected
 * @param range the shortest distance of a first detection, m; 0 for a drone that was never detected
 */
record RunRank(long late, long missed, double warning, double range) {
    private static final Comparator<RunRank> WORST_RANK_FIRST = Comparator.comparingLong(RunRank::late)
            .thenComparingLong(RunRank::missed)
            .reversed()
            .thenComparingDouble(RunRank::warning)
            .thenComparingDouble(RunRank::range);

    /** Orders runs by most late alerts, then most missing alerts, shortest warning time, shortest range. */
    static final Comparator<Ranked> WORST_FIRST = Comparator.comparing(Ranked::rank, WORST_RANK_FIRST)
            .thenComparingInt(ranked -> ranked.run().run());

    /** A run with its rank, computed once because it visits all pairs of the run. */
    record Ranked(RunResult run, RunRank rank) {
        Ranked(RunResult run) {
            this(run, RunRank.of(run));
        }
    }

    /**
     * Orders drones without an alert first, then those with a late one, the shortest warning time, the latest alert.
     */
    static final Comparator<AlertResult> WORST_ALERT_FIRST = Comparator.comparing(
                    (AlertResult alert) -> alert.time().isPresent())
            .thenComparing(alert -> !isLate(alert))
            .thenComparingDouble(alert -> alert.warning().orElse(Double.POSITIVE_INFINITY))
            .thenComparing(Comparator.comparingDouble(
                    (AlertResult alert) -> -alert.time().orElse(0.0)));

    static RunRank of(RunResult run) {
        List<AlertResult> alerts = run.attackAlerts();
        return new RunRank(
                alerts.stream().filter(RunRank::isLate).count(),
                alerts.stream().filter(alert -> alert.time().isEmpty()).count(),
                alerts.stream()
                        .mapToDouble(alert -> alert.warning().orElse(Double.POSITIVE_INFINITY))
                        .min()
                        .orElse(Double.POSITIVE_INFINITY),
                alerts.stream()
                        .mapToDouble(alert -> firstRange(run, alert.drone()).orElse(0.0))
                        .min()
                        .orElse(0.0));
    }

    static boolean isLate(AlertResult alert) {
        return alert.inTime().filter(enough -> !enough).isPresent();
    }

    /** How far away a drone was when the first sensor detected it, m. */
    static OptionalDouble firstRange(RunResult run, String drone) {
        return run.pairs().stream()
                .filter(pair ->
                        pair.drone().equals(drone) && pair.firstDetected().isPresent())
                .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()))
                .map(PairResult::range)
                .orElse(OptionalDouble.empty());
    }
}
