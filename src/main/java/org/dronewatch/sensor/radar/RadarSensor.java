package org.dronewatch.sensor.radar;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sample;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Point3d;

/**
 * A radar. Its value is the signal-to-noise ratio of the drone's echo; minus infinity for a drone that it does not look for,
 * because of where the drone is or how fast it comes, and for one that is wholly hidden. A drone that is hidden in part
 * counts for the part that shows.
 */
public final class RadarSensor implements Sensor {
    private static final String UNIT = "dB";

    private final RadarSettings settings;
    private final FieldOfRegard field;

    private World world;
    private VisibleShare visible;

    /** A radar of some settings. */
    public RadarSensor(RadarSettings settings) {
        this.settings = settings;
        this.field = new FieldOfRegard(settings);
    }

    @Override
    public List<Observation> observe(World site, List<Drone> drones, Sample sample) {
        if (site != world) {
            world = site;
            visible = new VisibleShare(site, settings.position());
        }
        return drones.stream().map(drone -> look(drone, sample)).toList();
    }

    private Observation look(Drone drone, Sample sample) {
        Position place = Position.of(drone.position());
        double range = Math.max(place.distance(settings.position()), Double.MIN_NORMAL);
        Position way = place.minus(settings.position());
        double speed = field.radialSpeed(drone);
        double share = field.contains(way) && field.hasSpeed(speed) ? visible.of(drone) : 0.0;
        double area = share * drone.settings().radar().towards(aspect(drone));
        double echo = echo(way, range, area);

        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("radial_speed_m_per_s", speed);
        figures.put("in_field", field.contains(way) ? 1.0 : 0.0);
        figures.put("visible_share", share);
        figures.put("cross_section_m2", area);
        double threshold = settings.detection()
                .threshold(drone.settings().radar().fluctuation(), sample.random(drone.id(), Sample.DETECTION));
        figures.put(
                Observation.PROBABILITY,
                settings.detection().probability(echo, drone.settings().radar().fluctuation()));
        Optional<Sighting> sighting = echo >= threshold
                ? Optional.of(settings.accuracy()
                        .sighting(settings.position(), place, sample.random(drone.id(), Sample.ERROR)))
                : Optional.empty();
        return new Observation(
                sample.sensor(),
                settings.kind(),
                drone.id(),
                sample.index(),
                sample.time(),
                sample.time(),
                range,
                echo,
                threshold,
                UNIT,
                figures,
                sighting);
    }

    /** Signal-to-noise ratio of an echo, dB, with what the rain takes on both ways. */
    private double echo(Position way, double range, double area) {
        if (area == 0.0) {
            return Double.NEGATIVE_INFINITY;
        }
        double elevation = Math.asin(Math.max(-1.0, Math.min(1.0, way.z() / range)));
        double rain = Rain.attenuation(settings.frequency(), world.rain(), elevation, settings.polarisation());
        return settings.budget().signalToNoise(settings.frequency(), area, range) - 2.0 * rain * range;
    }

    /** Where the radar is, clockwise from the drone's nose as seen from above. */
    private double aspect(Drone drone) {
        Point3d seen = settings.position().toPoint3d();
        drone.worldToModel().transform(seen);
        return Math.atan2(seen.x, seen.y);
    }

    /** What this radar was made from. */
    public RadarSettings settings() {
        return settings;
    }
}
