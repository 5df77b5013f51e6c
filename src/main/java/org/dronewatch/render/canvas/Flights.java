package org.dronewatch.render.canvas;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * The paths of a scene's drones, sampled evenly in time. During a run with steered drones, they are sampled up to the
 * present. Thread-safe.
 */
public final class Flights {
    private static final int STEPS = 600;

    /** Least margin around sensors and drones in a view of a site, m. */
    private static final double ROOM = 5.0;

    private final Map<String, List<Position>> positions = new LinkedHashMap<>();
    private final Stage stage;
    private final double step;
    private int sampled;
    private int boxed = -1;
    private AABB box;

    /** The flights of one run. */
    public Flights(SceneSettings settings, Stage stage) {
        this.stage = stage;
        this.step = settings.run().duration() / STEPS;
        sample();
    }

    /** Samples what has become known since the last call. */
    private void sample() {
        double known = stage.known();
        while (sampled <= STEPS && sampled * step <= known) {
            for (Drone drone : stage.dronesAt(sampled * step)) {
                positions.computeIfAbsent(drone.id(), id -> new ArrayList<>()).add(drone.origin());
            }
            sampled++;
        }
    }

    /**
     * A drone at a time, with its path until then and from then on.
     *
     * @param drone the drone at this time
     * @param time seconds since the start of the run
     * @param detected whether a sensor detects the drone at this time
     */
    public synchronized DroneMark mark(Drone drone, double time, boolean detected) {
        sample();
        List<Position> path = positions.get(drone.id());
        Position now = drone.origin();
        int next = (int) Math.min(Math.min(STEPS, path.size()), Math.floor(time / step) + 1.0);
        List<Position> flown = new ArrayList<>(path.subList(0, next));
        flown.add(now);
        List<Position> toCome = new ArrayList<>();
        toCome.add(now);
        toCome.addAll(path.subList(next, path.size()));
        return new DroneMark(drone, flown, toCome, detected);
    }

    /** The box, m, around all sensors and those parts of all flights that are known so far, with a margin. */
    public synchronized AABB interest(SceneSettings settings) {
        sample();
        if (boxed != sampled) {
            box = box(settings);
            boxed = sampled;
        }
        return box;
    }

    private AABB box(SceneSettings settings) {
        List<Position> all = new ArrayList<>();
        positions.values().forEach(all::addAll);
        settings.enabledSensors().values().forEach(sensor -> all.add(sensor.position()));
        if (all.isEmpty()) {
            all.add(new Position(0, 0, 0));
        }
        return AABB.around(all).grown(ROOM);
    }
}
