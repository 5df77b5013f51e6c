package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.route.FieldExposure;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;

/**
 * What the looks of a flight contribute to its exposure.
 *
 * @param steps what each look adds, in the order of time
 * @param bySensor the sum for each sensor, in the order of the scene
 */
record LookExposure(List<FlownExposure.Step> steps, List<Double> bySensor) {
    LookExposure {
        steps = List.copyOf(steps);
        bySensor = List.copyOf(bySensor);
    }

    /** The exposure, {@code -ln} of the probability that all looks have missed. */
    static LookExposure of(LookSchedule schedule) {
        double[] sums = new double[schedule.sensors().size()];
        double[] missed = schedule.missedAfterEach(MissedLooks.Wait.UNSEEN);
        List<FlownExposure.Step> steps = new ArrayList<>();
        for (int i = 0; i < missed.length; i++) {
            ScheduledLook look = schedule.looks().get(i);
            SensorSettings<?> sensor = schedule.sensors().get(look.number());
            double before = sums[look.number()];
            double now = sensor.chance() == Chance.PER_LOOK
                    ? before - Math.log1p(-Math.min(FieldExposure.HIGHEST, look.probability()))
                    : -Math.log(Math.max(Double.MIN_NORMAL, missed[i]));
            if (now > before) {
                double time = look.time() - schedule.begin();
                steps.add(new FlownExposure.Step(Math.max(0.0, time - 1.0 / sensor.rate()), time, now - before));
                sums[look.number()] = now;
            }
        }
        return new LookExposure(steps, Arrays.stream(sums).boxed().toList());
    }
}
