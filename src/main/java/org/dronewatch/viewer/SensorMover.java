package org.dronewatch.viewer;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.viewer.part.Texts;
import org.dronewatch.viewer.run.SensorLayout;
import org.dronewatch.world.World;

/**
 * Moves and turns one sensor of a {@link SensorLayout} at a time. A move that is not possible changes nothing, and one
 * line says why. For the event thread.
 */
final class SensorMover {
    /** Positions are rounded to centimetres, directions to tenths of a degree: nothing is installed more precisely. */
    private static final double IN_A_METRE = 100.0;

    private static final double IN_A_DEGREE = 10.0;

    private final SensorLayout layout;
    private final Consumer<String> messages;
    private Foothold foothold;
    private String selected;

    /**
     * A mover without a run.
     *
     * @param messages receives one line about each move
     */
    SensorMover(SensorLayout layout, Consumer<String> messages) {
        this.layout = layout;
        this.messages = messages;
    }

    /** Takes another run. */
    void show(SceneSettings settings, World world) {
        foothold = new Foothold(world);
        layout.show(settings);
    }

    /** Selects a sensor, or something else; null for nothing. */
    void select(String id) {
        selected = id;
    }

    /** The name of the selected sensor; empty if none is selected. */
    Optional<String> selected() {
        return Optional.ofNullable(selected)
                .filter(id -> layout.isThere() && layout.settings().sensors().containsKey(id));
    }

    /** The selected sensor, if it can be moved. */
    Optional<SensorSettings<?>> movable() {
        return selected()
                .filter(id -> layout.settings().isEnabled(id))
                .map(id -> layout.settings().sensors().get(id));
    }

    /** Why the selected sensor cannot be moved. */
    String obstacle() {
        return selected()
                .map(id -> "'" + id + "' is switched off in the scene: it covers nothing and stays where it is")
                .orElse("Select a sensor first: click on its symbol");
    }

    /** The point on which the selected sensor stands, m; empty in the air beyond the site. */
    Optional<Position> foot() {
        return movable().flatMap(sensor -> {
            Position at = sensor.position();
            OptionalDouble z = foothold.below(at);
            return z.isEmpty() ? Optional.empty() : Optional.of(new Position(at.x(), at.y(), z.getAsDouble()));
        });
    }

    /** How high the selected sensor is above what is below it, m; its own height where there is nothing. */
    double above() {
        Position at = movable().orElseThrow().position();
        return at.z() - foothold.below(at).orElse(0.0);
    }

    /** Remembers the layout before a move. */
    void begin() {
        layout.remember();
    }

    /**
     * Puts the selected sensor over a point of the site, as high above it as before.
     *
     * @param point on the ground, a roof or a wall, m; empty for the sky
     * @param above its height above that, m
     */
    void drag(Optional<Position> point, double above) {
        if (movable().isEmpty()) {
            return;
        }
        if (point.isEmpty()) {
            refuse("there is no ground");
            return;
        }
        double x = rounded(point.get().x());
        double y = rounded(point.get().y());
        put(x, y, foothold.below(x, y, point.get().z()), above);
    }

    /** Moves the selected sensor by a distance to the east and to the north, m, as high above what is below it. */
    void shift(double east, double north) {
        movable()
                .ifPresentOrElse(
                        sensor -> place(
                                sensor.position().x() + east, sensor.position().y() + north, above()),
                        () -> messages.accept(obstacle()));
    }

    /** Moves the selected sensor to a place, at a height above what is below it there, m. */
    void place(double x, double y, double above) {
        if (movable().isEmpty()) {
            messages.accept(obstacle());
            return;
        }
        begin();
        Position from = movable().get().position();
        put(rounded(x), rounded(y), foothold.after(from, rounded(x), rounded(y)), above);
    }

    /** Raises the selected sensor by a height, m; lowers it if that is negative. */
    void raise(double by) {
        movable()
                .ifPresentOrElse(
                        sensor -> place(sensor.position().x(), sensor.position().y(), above() + by),
                        () -> messages.accept(obstacle()));
    }

    private void put(double x, double y, OptionalDouble surface, double above) {
        if (surface.isEmpty()) {
            refuse("there is no ground");
            return;
        }
        if (above < 0.0) {
            refuse("it would be below the surface");
            return;
        }
        Position to = new Position(x, y, rounded(surface.getAsDouble() + above));
        // Rounding must not put a sensor that lies on a surface below it.
        Position clear = to.z() < surface.getAsDouble() ? to.plus(new Position(0.0, 0.0, 1.0 / IN_A_METRE)) : to;
        if (foothold.isInside(clear)) {
            refuse("it would be inside something solid");
            return;
        }
        String id = selected().orElseThrow();
        try {
            layout.set(id, movable().orElseThrow().withPosition(clear));
        } catch (IllegalArgumentException e) {
            refuse(e.getMessage());
            return;
        }
        messages.accept(String.format(
                Locale.ROOT,
                "'%s' is at %s, %.1f m above the surface below it",
                id,
                Texts.place(clear),
                clear.z() - surface.getAsDouble()));
    }

    private void refuse(String why) {
        messages.accept("'" + selected().orElseThrow() + "' stays where it is: " + why);
    }

    /** Turns the selected sensor by an angle to the right and one upwards, rad. */
    void turn(double right, double up) {
        direction()
                .ifPresentOrElse(
                        now -> aim(now.azimuth() + right, now.elevation() + up), () -> messages.accept(notAimed()));
    }

    /** The direction in which the selected sensor points; empty for one without. */
    Optional<Aim.Direction> direction() {
        return movable().flatMap(sensor -> sensor.as(Aimed.class).map(aimed -> {
            Position forward = aimed.aim().from(sensor.position());
            return new Aim.Direction(
                    StrictMath.atan2(forward.x(), forward.y()),
                    StrictMath.atan2(forward.z(), Math.hypot(forward.x(), forward.y())));
        }));
    }

    private String notAimed() {
        return movable().isEmpty()
                ? obstacle()
                : "'" + selected().orElseThrow() + "' has no direction: there is nothing to turn";
    }

    /**
     * Points the selected sensor in a direction.
     *
     * @param azimuth clockwise from north, rad
     * @param elevation above the horizon, rad
     */
    void aim(double azimuth, double elevation) {
        if (direction().isEmpty()) {
            messages.accept(notAimed());
            return;
        }
        String id = selected().orElseThrow();
        SensorSettings<?> sensor = movable().orElseThrow();
        if (Math.abs(elevation) > 0.5 * Math.PI) {
            messages.accept("'" + id + "' stays as it is: its tilt must be between -90 and 90 degrees");
            return;
        }
        begin();
        Aim.Direction to =
                new Aim.Direction(tenths(StrictMath.IEEEremainder(azimuth, 2.0 * Math.PI)), tenths(elevation));
        layout.set(id, sensor.as(Aimed.class).orElseThrow().withAim(to));
        messages.accept(
                Mounted.positioner(sensor).isPresent()
                        ? "'" + id
                                + "' is on a positioner, which turns it towards the drone:"
                                + " only its initial direction has changed"
                        : String.format(
                                Locale.ROOT,
                                "'%s' has an azimuth of %.1f degrees and a tilt of %+.1f degrees",
                                id,
                                degrees(to.azimuth()),
                                Math.toDegrees(to.elevation())));
    }

    /** An azimuth in degrees, 0 to 360. */
    static double degrees(double azimuth) {
        double turned = Math.toDegrees(azimuth);
        return turned < 0.0 ? turned + 360.0 : turned;
    }

    private static double tenths(double angle) {
        return Math.toRadians(Math.rint(Math.toDegrees(angle) * IN_A_DEGREE) / IN_A_DEGREE);
    }

    private static double rounded(double metres) {
        return Math.rint(metres * IN_A_METRE) / IN_A_METRE;
    }
}
