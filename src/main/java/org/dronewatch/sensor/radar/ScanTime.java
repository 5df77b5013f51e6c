package org.dronewatch.sensor.radar;

/**
 * The time that a radar takes to look in all directions of its field of view, one beam after the other. A beam of gain
 * G fills the solid angle {@code 4 pi / G} at best, without losses and side lobes (Skolnik, Radar Handbook): a real
 * scan takes longer.
 */
final class ScanTime {
    private ScanTime() {}

    /**
     * The fewest beams that fill a field of view.
     *
     * @param azimuthWidth horizontal width of the field of view, rad
     * @param elevationWidth vertical width of the field of view, centred on the horizon, rad
     * @param gain the lower of the gains of the radar's antennas, dBi
     */
    static long beams(double azimuthWidth, double elevationWidth, double gain) {
        double field = azimuthWidth * 2.0 * Math.sin(0.5 * elevationWidth);
        double fraction = field * Math.pow(10.0, 0.1 * gain) / (4.0 * Math.PI);
        return Math.max(1L, (long) Math.ceil(fraction));
    }
}
