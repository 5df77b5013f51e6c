package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sound.OctaveBands;

/** A part of a ray that was divided at a wall, as it leaves the wall. For use by one thread. */
final class PartOfRay {
    final AcousticRay ray = new AcousticRay();
    final Arrival arrival = new Arrival();
    final double[] energy = new double[OctaveBands.COUNT];
    boolean fromMirror;

    /** Takes over the state of a ray. */
    void save(AcousticRay other, Arrival path, double[] energies, boolean isFromMirror) {
        ray.copy(other);
        arrival.copy(path);
        System.arraycopy(energies, 0, energy, 0, energy.length);
        fromMirror = isFromMirror;
    }
}
