package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.Levels;

/** Records the segments of a ray for drawing, if they are wanted. For use by one thread. */
final class RecordedRay {
    /** The length at which segments that hit nothing are drawn, m. */
    private static final double DRAWN = 1000.0;

    private final EnergyModel model;
    private final AcousticRay ray;
    private final EnergyPacket energy;
    private Ends ends;
    private RayRecorder recorder;

    /**
     * Records one ray after the other.
     *
     * @param ray the ray, at the origin of the segment to be recorded
     * @param energy the energy that it carries there
     */
    RecordedRay(EnergyModel model, AcousticRay ray, EnergyPacket energy) {
        this.model = model;
        this.ray = ray;
        this.energy = energy;
    }

    void begin(Ends both, RayRecorder listener) {
        ends = both;
        recorder = listener;
    }

    /** Records the segment that the ray is about to travel, of a length in m, which may be infinite. */
    void flight(double length) {
        if (recorder != RayRecorder.NONE) {
            double drawn = Math.min(length, DRAWN);
            record(
                    ray.originX + drawn * ray.directionX,
                    ray.originY + drawn * ray.directionY,
                    ray.originZ + drawn * ray.directionZ,
                    false);
        }
    }

    /** Records that sound reaches the target from the ray's origin. */
    void arrival() {
        if (recorder != RayRecorder.NONE) {
            record(ends.target().x(), ends.target().y(), ends.target().z(), true);
        }
    }

    /** The level of a segment is that of the fraction of the source's power that the ray carries. */
    private void record(double toX, double toY, double toZ, boolean received) {
        double level = Levels.ofRatio(energy.all() * ends.source().emitted() / model.rays());
        recorder.record(ray.originX, ray.originY, ray.originZ, toX, toY, toZ, level, ray.order, received);
    }
}
