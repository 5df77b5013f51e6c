package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.PathBending;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.WindNoise;
import org.dronewatch.world.NoiseSource;
import org.dronewatch.world.World;

/**
 * The noise that a microphone hears without drones: the background, and the site's noise sources through the world. The
 * rays depend only on the names of the sources, so the noise is the same in every run. Sound that only a few rays carry
 * is part of it: without that sound, a drone would be heard too easily.
 *
 * @param levels sound pressure levels by band, dB re 20 uPa
 * @param isConverged whether a sufficient number of rays contributed to the sound of each source
 */
record SiteNoise(BandLevels levels, boolean isConverged) {
    private static final int BANDS = OctaveBands.COUNT;

    /**
     * The noise at a microphone.
     *
     * @param listener position of the microphone, m
     * @param tracer the tracer of sound to it
     */
    static SiteNoise at(Position listener, World world, EnergyTracer tracer) {
        BandLevels background = world.backgroundNoise().spectrum();
        double wind = new PathBending(world).windAt(listener);
        if (world.noiseSources().isEmpty() && !(wind > 0.0)) {
            return new SiteNoise(background, true);
        }
        double[] energy = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            energy[band] = Levels.toRatio(background.level(band)) + Levels.toRatio(WindNoise.level(band, wind));
        }
        boolean isConverged = true;
        for (Map.Entry<String, NoiseSource> source : world.noiseSources().entrySet()) {
            isConverged &= add(source.getKey(), source.getValue(), listener, tracer, energy);
        }
        double[] levels = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            levels[band] = Levels.ofRatio(energy[band]);
        }
        return new SiteNoise(BandLevels.of(levels), isConverged);
    }

    /** Adds the energy of a source, and returns whether all of its parts have converged. */
    private static boolean add(
            String name, NoiseSource source, Position listener, EnergyTracer tracer, double[] energy) {
        boolean isConverged = true;
        List<NoiseSource.Piece> pieces = source.pieces(listener);
        for (int i = 0; i < pieces.size(); i++) {
            List<Double> power = new ArrayList<>();
            for (double level : source.power().toArray()) {
                power.add(level + Levels.ofRatio(pieces.get(i).fraction()));
            }
            SoundSource piece = new SoundSource(pieces.get(i).position(), power, Directivity.OMNIDIRECTIONAL);
            EnergyReading heard = tracer.trace(piece, Draws.stream(0L, "", name, i, "noise"), RayRecorder.NONE);
            // Rays alone can never prove silence, but a source whose sound arrives by no path and no ray adds nothing.
            isConverged &= heard.isConverged() || heard.totalLevel() == Double.NEGATIVE_INFINITY;
            for (int band = 0; band < BANDS; band++) {
                energy[band] += Levels.toRatio(heard.level(band));
            }
        }
        return isConverged;
    }
}
