package org.example.watch;

import java.util.Map;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.acoustic.propagation.Heard;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sensor.acoustic.propagation.SoundTracer;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;

/**
 * Sound spreads on a sphere and meets nothing. Who listens is not always attentive: a level near the threshold is
 * noticed with a probability that rises with it by the logistic function.
 *
 * @param reference distance at which a drone has its sound level, m
 * @param slope by how much the level must rise for odds of e to 1, dB; at 0 the threshold is sharp
 */
public record SphericalSpreading(
        @In(value = Quantity.LENGTH, above = 0.0, to = 100.0) double reference,
        @In(value = Quantity.LEVEL, from = 0.0, to = 20.0) double slope)
        implements Propagation {
    @Defaults
    public static final SphericalSpreading DEFAULT = new SphericalSpreading(1.0, 0.0);

    public SphericalSpreading {
        Limits.check(SphericalSpreading.class, reference, slope);
    }

    @Override
    public String measures() {
        return "level by spreading";
    }

    @Override
    public SoundTracer tracer(Microphone microphone, World world) {
        double threshold = microphone.detectionLevel(world.backgroundNoise().level());
        return new SoundTracer() {
            private double level(Drone drone) {
                return drone.soundLevel() - 20.0 * Math.log10(drone.distance(microphone.position()) / reference);
            }

            @Override
            public Heard hear(Drone drone, RandomGenerator random) {
                double drawn = random.nextDouble();
                double luck = slope == 0.0 ? 0.0 : slope * Math.log(drawn / (1.0 - drawn));
                return new Heard(level(drone) + luck, threshold, Map.of());
            }

            @Override
            public Signal signal(Drone drone, RandomGenerator random) {
                double level = level(drone);
                return slope == 0.0
                        ? Signal.certain(level, "dB", threshold)
                        : Signal.of(1.0 / (1.0 + Math.exp((threshold - level) / slope)), level, "dB", threshold);
            }

            @Override
            public boolean isHeardInTheOpen(Drone drone) {
                return level(drone) >= threshold;
            }
        };
    }
}
