package org.dronewatch.sensor.acoustic;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sample;
import org.dronewatch.world.Drone;
import org.dronewatch.world.World;

/** A microphone that hears each drone for itself. Keeps scratch memory: one thread at a time. */
public final class AcousticSensor implements RaySensor {
    private static final String UNIT = "dB";

    private final AcousticSettings settings;
    private World heard;
    private LevelTracer tracer;

    /** A sensor of some settings. */
    public AcousticSensor(AcousticSettings settings) {
        this.settings = settings;
    }

    /** Listens to each drone until it is detected or nothing is left to trace. */
    @Override
    public List<Observation> observe(World world, List<Drone> drones, Sample sample) {
        List<Observation> observations = new ArrayList<>(drones.size());
        for (Drone drone : drones) {
            Listening listening = listen(world, drone, sample.random());
            observations.add(new Observation(
                    sample.sensor(),
                    settings.kind(),
                    drone.id(),
                    sample.index(),
                    sample.time(),
                    drone.distance(settings.position()),
                    listening.bestLevel(),
                    settings.detectionLevel(world.backgroundNoise()),
                    UNIT,
                    listening.figures()));
        }
        return observations;
    }

    /** Traces until the first ray that is loud enough: the quick answer. */
    public Listening listen(World world, Drone drone, RandomGenerator random) {
        return tracer(world).trace(place(drone), drone.settings().soundLevel(), random, false, RayRecorder.NONE);
    }

    /**
     * Traces everything.
     *
     * @param recorder is told every piece of every ray; {@link RayRecorder#NONE} when nobody wants to know
     */
    public Listening listenFully(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        return tracer(world).trace(place(drone), drone.settings().soundLevel(), random, true, recorder);
    }

    @Override
    public void traceRays(World world, Drone drone, RandomGenerator random, RayRecorder recorder) {
        listenFully(world, drone, random, recorder);
    }

    private static Position place(Drone drone) {
        return Position.of(drone.position());
    }

    private LevelTracer tracer(World world) {
        if (heard != world) {
            tracer = new LevelTracer(settings, world);
            heard = world;
        }
        return tracer;
    }

    /** What this sensor was made from. */
    public AcousticSettings settings() {
        return settings;
    }
}
