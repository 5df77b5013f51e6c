package org.dronewatch.sensor;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** Finds the obstacles that hide drones from a sensor. Keeps scratch memory: for use by one thread at a time. */
public final class Cover {
    private final Visibility visibility;
    private final Position sensor;

    /**
     * Finds what hides drones from a sensor in a world.
     *
     * @param sensor position of the sensor, m
     */
    public Cover(World world, Position sensor) {
        this.visibility = new Visibility(world);
        this.sensor = sensor;
    }

    /** The world. */
    public World world() {
        return visibility.world();
    }

    /** The first obstacle between the sensor and the drone's origin; empty if there is none. */
    public Optional<Obstacle> ofOrigin(Drone drone) {
        return ofPoint(drone.origin());
    }

    /** The first obstacle between the sensor and a point, m; empty if there is none. */
    public Optional<Obstacle> ofPoint(Position point) {
        return visibility.obstacle(sensor, point);
    }

    /**
     * The obstacle that hides the drone's origin or, if none does, the first hidden vertex of its mesh; empty if
     * nothing hides either.
     */
    public Optional<Obstacle> of(Drone drone) {
        Optional<Obstacle> before = ofOrigin(drone);
        TriangleMesh mesh = drone.tree().mesh();
        for (int i = 0; before.isEmpty() && i < mesh.vertexCount(); i++) {
            Position corner =
                    new Position(mesh.vertexCoordinate(i, 0), mesh.vertexCoordinate(i, 1), mesh.vertexCoordinate(i, 2));
            before = visibility.obstacle(sensor, drone.toWorld(corner));
        }
        return before;
    }

    /**
     * The reason why a drone in range and in view is missed: hidden, or too weak. Conditions that cost more than a ray
     * are evaluated only where they matter.
     *
     * @param invisible whether the sensor receives nothing from the drone
     * @param detectedInTheOpen whether the drone would be detected if nothing hid it
     */
    public Explanation explain(Drone drone, BooleanSupplier invisible, BooleanSupplier detectedInTheOpen) {
        Optional<Obstacle> before = ofOrigin(drone);
        boolean hidden = before.isPresent()
                ? invisible.getAsBoolean() || detectedInTheOpen.getAsBoolean()
                : detectedInTheOpen.getAsBoolean();
        if (hidden && before.isEmpty()) {
            before = of(drone);
        }
        return before.filter(obstacle -> hidden)
                .map(Explanation::hiddenBy)
                .orElseGet(() -> Explanation.of(Cause.TOO_WEAK));
    }
}
