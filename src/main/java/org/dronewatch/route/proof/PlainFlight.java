package org.dronewatch.route.proof;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.ConfirmedLooks;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;

/** A flight of a route as a plain run, with which the replay of its looks is compared. */
final class PlainFlight {
    private final SceneSettings settings;
    private final ModelCache models;

    /**
     * A flight.
     *
     * @param settings settings of a scene with one drone
     */
    PlainFlight(SceneSettings settings, ModelCache models) {
        this.settings = settings;
        this.models = models;
    }

    /**
     * Runs it on this thread alone, since the runs themselves are shared out among the threads: up to the first
     * detection on the route or, if alerts are asked for, up to the alert.
     *
     * @param alerts if given, how an alert by any single sensor is confirmed
     */
    FlownRun fly(long seed, Optional<Confirmation> alerts) {
        try (Workers alone = new Workers(1)) {
            return alone.call(() -> run(seed, alerts));
        }
    }

    private FlownRun run(long seed, Optional<Confirmation> alerts) {
        try (RunSession session = new RunSession(settings, seed, models)) {
            double begin = RouteScene.begin(settings);
            Map<String, ConfirmedLooks> confirmed = new HashMap<>();
            Optional<Observation> first = Optional.empty();
            OptionalDouble alert = OptionalDouble.empty();
            while (session.nextTime().isPresent() && (first.isEmpty() || alerts.isPresent() && alert.isEmpty())) {
                List<Observation> onRoute = session.advance().observations().stream()
                        .filter(one -> one.truth().time() >= begin)
                        .toList();
                first = first.or(() -> SeededFlights.detection(onRoute));
                if (alerts.isPresent() && isAlert(onRoute, confirmed, alerts.get())) {
                    alert = OptionalDouble.of(session.reached());
                }
            }
            // The run's own alert would also count what sensors see of the drone while it waits for its route to begin.
            boolean isOwn = alerts.isPresent() && begin == 0.0;
            return new FlownRun(first, isOwn ? session.result().alerts().get(0).time() : alert);
        }
    }

    /** Whether the looks of one time raise the alert: whether those of any single sensor confirm it. */
    private static boolean isAlert(
            List<Observation> observations, Map<String, ConfirmedLooks> confirmed, Confirmation confirmation) {
        Map<String, Boolean> looks = new LinkedHashMap<>();
        observations.stream()
                .filter(one -> !one.isFalse())
                .forEach(one -> looks.merge(one.sensor(), one.isDetected(), Boolean::logicalOr));
        boolean isAlert = false;
        for (Map.Entry<String, Boolean> look : looks.entrySet()) {
            isAlert |= confirmed
                    .computeIfAbsent(look.getKey(), sensor -> new ConfirmedLooks(confirmation))
                    .add(look.getValue());
        }
        return isAlert;
    }
}
