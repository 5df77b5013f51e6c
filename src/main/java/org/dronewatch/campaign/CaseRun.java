package org.dronewatch.campaign;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.campaign.outcome.DroneOutcome;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.Stage;
import org.dronewatch.run.ZoneApproach;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** Runs one case of a campaign with one variant; the result is the same whatever else is run, in whatever order. */
public final class CaseRun {
    private static final double TURN = 2.0 * Math.PI;

    private CaseRun() {}

    /**
     * Runs a case on the calling thread.
     *
     * @return the result of the case; for a case whose settings are not valid together, or whose run fails, a failed
     *     result
     * @throws java.util.concurrent.CancellationException when the thread is interrupted
     */
    public static CaseResult of(CampaignPlan plan, int number, String variant) {
        return of(plan, plan, number, variant);
    }

    static CaseResult of(CampaignPlan plan, Cases cases, int number, String variant) {
        List<String> values = cases.values(number);
        long seed = cases.seed(number);
        try {
            SceneSettings settings = plan.settings(cases, number, variant);
            try (RunSession session =
                    new RunSession(settings, seed, plan.variant(variant).models())) {
                while (session.nextTime().isPresent()) {
                    session.advance();
                }
                return result(number, variant, values, session.stage(), session.result());
            }
        } catch (RuntimeException e) {
            // Whatever is wrong with one case must not cost the results of the others.
            Workers.checkInterrupted();
            return CaseResult.failed(number, variant, seed, values, PlainText.line(reason(e)));
        }
    }

    private static String reason(RuntimeException problem) {
        boolean isExplained = problem instanceof InputException
                || problem instanceof IllegalArgumentException
                || problem instanceof IllegalStateException;
        return isExplained ? String.valueOf(problem.getMessage()) : "internal error: " + problem;
    }

    private static CaseResult result(int number, String variant, List<String> values, Stage stage, RunResult run) {
        List<String> attackers =
                run.attackAlerts().stream().map(AlertResult::drone).toList();
        Optional<PairResult> first = run.pairs().stream()
                .filter(pair -> attackers.contains(pair.drone()))
                .filter(pair -> pair.firstDetected().isPresent())
                .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()));
        Optional<AlertResult> alert = run.attackAlerts().stream()
                .filter(one -> one.time().isPresent())
                .min(Comparator.comparingDouble(one -> one.time().getAsDouble()));
        Optional<Boolean> inTime = alert.isPresent()
                ? alert.get().inTime()
                : run.attackAlerts().stream().findFirst().flatMap(AlertResult::inTime);
        return new CaseResult(
                number,
                variant,
                run.settings().run().seed(),
                values,
                Optional.empty(),
                attackers.isEmpty() ? OptionalDouble.empty() : bearing(run.settings(), stage, attackers.get(0)),
                first.map(PairResult::firstDetected).orElse(OptionalDouble.empty()),
                first.map(PairResult::sensor),
                first.map(PairResult::range).orElse(OptionalDouble.empty()),
                alert.map(AlertResult::time).orElse(OptionalDouble.empty()),
                alert.map(AlertResult::warning).orElse(OptionalDouble.empty()),
                inTime,
                closest(stage, run),
                isCutShort(stage, run),
                drones(run));
    }

    private static OptionalDouble closest(Stage stage, RunResult run) {
        if (stage.protection().isEmpty()) {
            return OptionalDouble.empty();
        }
        return run.attackAlerts().stream()
                .mapToDouble(one -> one.entered().isPresent()
                        ? 0.0
                        : approach(stage, one, run).closest())
                .min();
    }

    private static boolean isCutShort(Stage stage, RunResult run) {
        return !stage.protection().isEmpty()
                && run.attackAlerts().stream()
                        .filter(one -> one.alert().isEmpty() && one.entered().isEmpty())
                        .anyMatch(one -> approach(stage, one, run).isCutShort());
    }

    private static ZoneApproach approach(Stage stage, AlertResult one, RunResult run) {
        return new ZoneApproach(stage.flight(one.drone()), stage.protection(), run.simulated());
    }

    private static Map<String, DroneOutcome> drones(RunResult run) {
        Map<String, DroneOutcome> drones = new LinkedHashMap<>();
        for (AlertResult alert : run.attackAlerts()) {
            boolean isDetected = run.pairs().stream()
                    .anyMatch(pair -> pair.drone().equals(alert.drone())
                            && pair.firstDetected().isPresent());
            drones.put(alert.drone(), DroneOutcome.of(isDetected, alert.time().isPresent(), alert.inTime()));
        }
        return drones;
    }

    private static OptionalDouble bearing(SceneSettings settings, Stage stage, String drone) {
        if (stage.protection().isEmpty() && settings.enabledSensors().isEmpty()) {
            return OptionalDouble.empty();
        }
        Position middle = InboundTarget.of(settings, stage.protection());
        Position start = stage.positionOf(drone, 0.0);
        double angle = StrictMath.atan2(start.x() - middle.x(), start.y() - middle.y());
        return OptionalDouble.of(angle < 0.0 ? angle + TURN : angle);
    }
}
