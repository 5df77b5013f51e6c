package org.dronewatch.sound.surface;

import org.dronewatch.sound.OctaveBands;

/**
 * The mean energy of direct and ground-reflected sound together in an octave band: the average, uniform in lg f, of
 * {@code a1^2 + a2^2 |Q|^2 + 2 a1 a2 |Q| C cos(k (R2 - R1) + arg Q)}. The amplitude of the direct sound is a1, that of
 * the reflected sound over rigid ground is a2, R1 and R2 are the lengths of their paths, k is the wavenumber, Q the
 * spherical-wave reflection coefficient of the ground and C the coherence. The caller accounts for spreading, air and
 * directivity.
 *
 * @param ground impedance of the ground
 * @param soundSpeed speed of sound, above 0, m/s
 * @param direct length of the direct path R1, m, above 0
 * @param reflected length of the reflected path R2, m, R1 or more
 * @param sourceHeight height of the source above the plane of the ground, m, 0 or more
 * @param receiverHeight height of the receiver above that plane, m, 0 or more
 * @param unevenness standard deviation s of the ground's height about the plane, m, 0 or more: the coherent fraction of
 *     the reflected wave is {@code exp(-2 (k s cos t)^2)}, where {@code k s cos t} is Rayleigh's roughness parameter, k
 *     the wavenumber and t the angle of incidence
 * @param turbulence turbulence of the air
 */
public record GroundInterference(
        GroundImpedance ground,
        double soundSpeed,
        double direct,
        double reflected,
        double sourceHeight,
        double receiverHeight,
        double unevenness,
        TurbulentCoherence turbulence) {
    /**
     * The number of parts of a band. In each part, Q and the coherence are taken as constant, and the phase of the path
     * difference is integrated.
     */
    private static final int PARTS = 24;

    /** Width of an octave band in decades (IEC 61260-1, base ten). */
    private static final double OCTAVE = 0.3;

    /**
     * The mean energy in a band.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @param directEnergy energy of the direct path alone, a1 squared
     * @param reflectedEnergy energy of the reflected path alone, over rigid ground, a2 squared
     * @return in the unit of the two energies
     */
    public double inBand(int band, double directEnergy, double reflectedEnergy) {
        double sum = 0.0;
        for (int part = 0; part < PARTS; part++) {
            double width = waveNumber(frequency(band, part + 1.0)) - waveNumber(frequency(band, part));
            sum += energy(frequency(band, part + 0.5), width, directEnergy, reflectedEnergy);
        }
        return sum / PARTS;
    }

    /**
     * The energy at one frequency.
     *
     * @param frequency frequency, above 0, Hz
     * @param directEnergy energy of the direct path alone, a1 squared
     * @param reflectedEnergy energy of the reflected path alone, over rigid ground, a2 squared
     * @return in the unit of the two energies
     */
    public double atFrequency(double frequency, double directEnergy, double reflectedEnergy) {
        return energy(frequency, 0.0, directEnergy, reflectedEnergy);
    }

    /** The mean over the wavenumbers in an interval of a given width, 1/m, centred on the wavenumber of a frequency. */
    private double energy(double frequency, double width, double directEnergy, double reflectedEnergy) {
        double waveNumber = waveNumber(frequency);
        double cosine = (sourceHeight + receiverHeight) / reflected;
        Complex q = SphericalReflection.coefficient(ground, frequency, soundSpeed, reflected, cosine);
        double size = q.absolute();
        double difference = reflected - direct;
        double uneven = unevenness * cosine;
        double apart = TurbulentCoherence.separation(sourceHeight, receiverHeight);
        double coherence =
                Math.exp(-waveNumber * waveNumber * (turbulence.exponent(direct, apart) + 2.0 * uneven * uneven));
        double phase = waveNumber * difference + Math.atan2(q.im(), q.re());
        return directEnergy
                + reflectedEnergy * size * size
                + 2.0
                        * Math.sqrt(directEnergy * reflectedEnergy)
                        * size
                        * coherence
                        * Math.cos(phase)
                        * sinc(0.5 * difference * width);
    }

    private double waveNumber(double frequency) {
        return 2.0 * Math.PI * frequency / soundSpeed;
    }

    private static double frequency(int band, double part) {
        return OctaveBands.midband(band) * Math.pow(10.0, OCTAVE * (part / PARTS - 0.5));
    }

    private static double sinc(double x) {
        return x == 0.0 ? 1.0 : Math.sin(x) / x;
    }
}
