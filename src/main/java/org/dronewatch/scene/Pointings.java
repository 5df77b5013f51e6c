package org.dronewatch.scene;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.sensor.positioner.Pointing;

/** Remembers where the mounts of a run's sensors pointed. One thread at a time. */
public final class Pointings {
    private final Map<String, TreeMap<Double, Pointing>> known = new HashMap<>();

    /** Takes what a frame tells. */
    public void add(Frame frame) {
        frame.pointings().forEach((sensor, pointing) -> known.computeIfAbsent(sensor, name -> new TreeMap<>())
                .put(frame.time(), pointing));
    }

    /** Where the mount of a sensor pointed at its last look up to a time, s; empty for a sensor that stands still. */
    public Optional<Pointing> at(String sensor, double time) {
        return Optional.ofNullable(known.get(sensor))
                .flatMap(looks -> Optional.ofNullable(looks.floorEntry(time)))
                .map(Map.Entry::getValue);
    }
}
