package org.dronewatch.fuzz;

import java.util.List;
import java.util.stream.Collectors;
import org.dronewatch.kdtree.KernelTarget;

/** All targets of random input. */
final class Targets {

    private Targets() {}

    /** All targets, in the order in which they run. */
    static List<FuzzTarget> all() {
        return List.of(
                new FilesTarget(),
                new TextTarget(),
                new ObjTarget(),
                new ModelTarget(),
                new TerrainTarget(),
                new MapTarget(),
                new FlightTarget(),
                new YamlTarget(),
                new SetTarget(),
                new KernelTarget(),
                new RunTarget());
    }

    /** The target of a name. */
    static FuzzTarget named(String name) {
        return all().stream()
                .filter(target -> target.name().equals(name.strip()))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no target '" + name + "', only "
                        + all().stream().map(FuzzTarget::name).collect(Collectors.joining(", "))));
    }
}
