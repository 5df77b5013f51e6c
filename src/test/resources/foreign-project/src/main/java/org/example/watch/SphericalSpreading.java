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
 * Sound spreads on a sphere and meets nothing.
 *
 * @param reference distance at which a drone has its sound level, m
 */
public record SphericalSpreading(@In(value = Quantity.LENGTH, above = 0.0, to = 100.0) double reference)
        implements Propagation {
    @Defaults
    public static final SphericalSpreading DEFAULT = new SphericalSpreading(1.0);

    public SphericalSpreading {
        Limits.check(SphericalSpreading.class, reference);
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
                return new Heard(level(drone), threshold, Map.of());
            }

            @Override
            public Signal signal(Drone drone, RandomGenerator random) {
                return Signal.certain(level(drone), "dB", threshold);
            }

            @Override
            public boolean isHeardInTheOpen(Drone drone) {
                return level(drone) >= threshold;
            }
        };
    }
}
