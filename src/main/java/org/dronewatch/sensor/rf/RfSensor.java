package org.dronewatch.sensor.rf;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sample;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.world.World;

/**
 * A radio receiver. Its value is the signal-to-noise ratio of the stronger of a drone's own emission and its pilot's; minus
 * infinity for a drone that is silent, and for a carrier that it does not hear. Keeps scratch memory: one thread at a time.
 */
public final class RfSensor implements Sensor {
    private static final String UNIT = "dB";

    private final RfSettings settings;
    private RadioPath path;

    /** A receiver of some settings. */
    public RfSensor(RfSettings settings) {
        this.settings = settings;
    }

    @Override
    public List<Observation> observe(World world, List<Drone> drones, Sample sample) {
        if (path == null || path.world() != world) {
            path = new RadioPath(world);
        }
        return drones.stream().map(drone -> listen(drone, sample)).toList();
    }

    private Observation listen(Drone drone, Sample sample) {
        RadioLink link = drone.settings().radio();
        double ofDrone = ratio(link, Position.of(drone.position()), link.power());
        double ofPilot =
                link.pilot().map(place -> ratio(link, place, link.pilotPower())).orElse(Double.NEGATIVE_INFINITY);
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("drone_snr_db", ofDrone);
        figures.put("pilot_snr_db", ofPilot);
        return new Observation(
                sample.sensor(),
                settings.kind(),
                drone.id(),
                sample.index(),
                sample.time(),
                sample.time(),
                drone.distance(settings.position()),
                Math.max(ofDrone, ofPilot),
                settings.threshold(),
                UNIT,
                figures);
    }

    /** Signal-to-noise ratio of an emission from a place, dB. */
    private double ratio(RadioLink link, Position from, double power) {
        double carrier = link.frequency();
        if (!link.emits() || carrier < settings.lowest() || carrier > settings.highest()) {
            return Double.NEGATIVE_INFINITY;
        }
        // In the near field the formula means nothing; nearer than a metre is as good as a metre.
        double distance = Math.max(1.0, from.distance(settings.position()));
        double loss = RadioPath.freeSpaceLoss(distance, carrier)
                + path.obstacleLoss(from, settings.position(), carrier)
                + settings.clutter();
        return power + settings.gain() - loss - settings.noise();
    }

    /** What this receiver was made from. */
    public RfSettings settings() {
        return settings;
    }
}
