package org.dronewatch.sensor.acoustic.energy;

import java.util.ArrayList;
import java.util.List;
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
 * The noise that a microphone hears without drones: the background, and the site's noise sources through the world. Its
 * rays depend on the names of the sources only, so it is the same in every run.
 */
final class SiteNoise {
    private static final int BANDS = OctaveBands.COUNT;

    private SiteNoise() {}

    /**
     * Levels by band, dB re 20 uPa.
     *
     * @param listener where the microphone is, m
     * @param tracer that traces sound to it
     */
    static BandLevels at(Position listener, World world, EnergyTracer tracer) {
        BandLevels background = world.backgroundNoise().spectrum();
        double wind = new PathBending(world).windAt(listener);
        if (world.noiseSources().isEmpty() && !(wind > 0.0)) {
            return background;
        }
        double[] energy = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            energy[band] = Levels.toRatio(background.level(band)) + Levels.toRatio(WindNoise.level(band, wind));
        }
        world.noiseSources().forEach((name, source) -> add(name, source, listener, tracer, energy));
        double[] levels = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            levels[band] = Levels.ofRatio(energy[band]);
        }
        return BandLevels.of(levels);
    }

    private static void add(String name, NoiseSource source, Position listener, EnergyTracer tracer, double[] energy) {
        List<NoiseSource.Piece> pieces = source.pieces(listener);
        for (int i = 0; i < pieces.size(); i++) {
            List<Double> power = new ArrayList<>();
            for (double level : source.power().toArray()) {
                power.add(level + Levels.ofRatio(pieces.get(i).fraction()));
            }
            SoundSource piece = new SoundSource(pieces.get(i).position(), power, Directivity.OMNIDIRECTIONAL);
            EnergyReading heard = tracer.trace(piece, Draws.stream(0L, "", name, i, "noise"), RayRecorder.NONE);
            for (int band = 0; band < BANDS; band++) {
                energy[band] += Levels.toRatio(heard.level(band));
            }
        }
    }
}
