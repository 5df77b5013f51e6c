package org.dronewatch.report.html;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.Drone;
import org.dronewatch.world.World;

/** Says why a sensor did not detect a drone: never in its field of view, hidden, out of range, or too weak. */
final class Reasons {
    /** So many moments of a run are looked at. */
    private static final int MOMENTS = 400;

    private final SceneSettings settings;
    private final Stage stage;

    Reasons(SceneSettings settings, Stage stage) {
        this.settings = settings;
        this.stage = stage;
    }

    /** Why a sensor missed a drone, in words, by its best look. */
    String of(String sensor, String drone, Optional<Look> best) {
        SensorSettings<?> missing = settings.sensors().get(sensor);
        int inView = 0;
        int free = 0;
        double nearest = Double.POSITIVE_INFINITY;
        World world = stage.world();
        for (int i = 0; i <= MOMENTS; i++) {
            Position place = placeOf(drone, settings.run().duration() * i / MOMENTS);
            nearest = Math.min(nearest, place.distance(missing.position()));
            if (isInside(missing, place)) {
                inView++;
                free += world.isOccluded(missing.position().toPoint3d(), place.toPoint3d()) ? 0 : 1;
            }
        }
        boolean looks = missing.outline()
                .filter(outline -> !(outline instanceof Outline.Ball))
                .isPresent();
        if (looks && inView == 0) {
            return missing.outline().orElseThrow() instanceof Outline.Sector sector && nearest > sector.maxRange()
                    ? format(
                            "out of range: it looks %.0f m far, the drone came as near as %.0f m",
                            sector.maxRange(), nearest)
                    : format("never in its field of view; nearest at %.0f m", nearest);
        }
        if (looks && free == 0) {
            return "hidden by the site whenever it was in its field of view";
        }
        return best.filter(look -> Double.isFinite(look.value()) && look.value() != 0.0)
                .map(look -> format(
                        "too weak: at best %s of %s %s, at %.0f m",
                        number(look.value()), number(look.threshold()), look.unit(), look.range()))
                .orElse(looks ? "too weak for any reading" : "nothing of it arrived that the sensor could hear");
    }

    private Position placeOf(String drone, double time) {
        for (Drone one : stage.dronesAt(time)) {
            if (one.id().equals(drone)) {
                return Position.of(one.position());
            }
        }
        throw new IllegalArgumentException("no drone '" + drone + "'");
    }

    private static boolean isInside(SensorSettings<?> sensor, Position place) {
        Position way = place.minus(sensor.position());
        Outline outline = sensor.outline().orElse(null);
        if (outline instanceof Outline.Pyramid pyramid) {
            double ahead = dot(way, pyramid.forward());
            return ahead > 0.0
                    && Math.abs(dot(way, pyramid.right())) <= pyramid.halfWidth() * ahead
                    && Math.abs(dot(way, pyramid.up())) <= pyramid.halfHeight() * ahead;
        }
        if (outline instanceof Outline.Sector sector) {
            double range = way.length();
            double level = Math.hypot(way.x(), way.y());
            double aside = Math.IEEEremainder(Math.atan2(way.x(), way.y()) - sector.azimuth(), 2.0 * Math.PI);
            double above = Math.atan2(way.z(), level) - sector.elevation();
            return range >= sector.minRange()
                    && range <= sector.maxRange()
                    && Math.abs(aside) <= 0.5 * sector.azimuthWidth() + 1e-9
                    && Math.abs(above) <= 0.5 * sector.elevationWidth() + 1e-9;
        }
        return true;
    }

    private static double dot(Position a, Position b) {
        return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    /** Three digits at most. */
    static String number(double value) {
        return Math.abs(value) >= 100.0 || value == Math.rint(value) ? format("%.0f", value) : format("%.1f", value);
    }
}
