package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.route.FieldExposure;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;

/** Adds up what the looks of a flight contribute to its exposure. */
final class LookExposure {
    private LookExposure() {}

    /**
     * The exposure, {@code -ln} of the probability that all looks have missed.
     *
     * @param names of the sensors, in the order of the scene
     */
    static FlownExposure of(LookSchedule schedule, List<String> names) {
        double[] sums = new double[names.size()];
        List<List<ScheduledLook>> taken = new ArrayList<>();
        names.forEach(name -> taken.add(new ArrayList<>()));
        List<FlownExposure.Step> steps = new ArrayList<>();
        for (ScheduledLook look : schedule.looks()) {
            if (look.probability() > 0.0) {
                SensorSettings<?> sensor = schedule.sensors().get(look.number());
                double before = sums[look.number()];
                double now = sensor.chance() == Chance.PER_LOOK
                        ? before - Math.log1p(-Math.min(FieldExposure.HIGHEST, look.probability()))
                        : ofEncounters(taken.get(look.number()), look, sensor);
                if (now > before) {
                    double since = Math.max(0.0, look.time() - 1.0 / sensor.rate());
                    steps.add(new FlownExposure.Step(since, look.time(), now - before));
                    sums[look.number()] = now;
                }
            }
        }
        Map<String, Double> bySensor = new LinkedHashMap<>();
        for (int sensor = 0; sensor < sums.length; sensor++) {
            bySensor.put(names.get(sensor), sums[sensor]);
        }
        return new FlownExposure(steps, bySensor);
    }

    private static double ofEncounters(List<ScheduledLook> taken, ScheduledLook look, SensorSettings<?> sensor) {
        taken.add(look);
        return -Math.log(Math.max(Double.MIN_NORMAL, MissedLooks.probability(taken, sensor)));
    }
}
