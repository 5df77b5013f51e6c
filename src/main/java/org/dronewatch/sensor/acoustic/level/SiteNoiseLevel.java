package org.dronewatch.sensor.acoustic.level;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.Microphone;
import org.dronewatch.sound.Levels;
import org.dronewatch.world.NoiseSource;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The noise that a microphone hears without drones in the level model: the background and, for each of the site's noise
 * sources, the highest level that arrives from any part of it, since levels are not divided. The rays depend only on
 * the names of the sources, so the noise is the same in every run.
 */
final class SiteNoiseLevel {
    /** Noise that is this many decibels below the background is not traced: it would raise the noise by 0.04 dB. */
    private static final double INAUDIBLE = 20.0;

    private SiteNoiseLevel() {}

    /** The level, dB. */
    static double of(LevelModel model, Microphone microphone, World world) {
        double background = world.backgroundNoise().level();
        boolean isAlone = world.noiseSources().values().stream()
                .allMatch(source -> source.soundLevel().isEmpty());
        if (isAlone) {
            return background;
        }
        double lowest = background - INAUDIBLE;
        LevelTracer tracer = new LevelTracer(model, microphone.position(), microphone.radius(), lowest, world);
        Visibility visibility = new Visibility(world);
        double[] energy = {Levels.toRatio(background)};
        world.noiseSources().forEach((name, source) -> source.soundLevel()
                .ifPresent(level -> energy[0] += Levels.toRatio(
                        highest(name, source, level, lowest, microphone.position(), model, tracer, visibility))));
        return Levels.ofRatio(energy[0]);
    }

    /** The highest level from any part of a source; no reflection is louder than the straight path. */
    private static double highest(
            String name,
            NoiseSource source,
            double level,
            double lowest,
            Position listener,
            LevelModel model,
            LevelTracer tracer,
            Visibility visibility) {
        double highest = Double.NEGATIVE_INFINITY;
        List<NoiseSource.Piece> pieces = source.pieces(listener);
        for (int i = 0; i < pieces.size(); i++) {
            Position from = pieces.get(i).position();
            double straight = level - model.attenuation() * from.distance(listener);
            if (straight <= highest || straight < lowest) {
                continue;
            }
            highest = visibility.isFree(from, listener)
                    ? straight
                    : Math.max(
                            highest,
                            tracer.trace(from, level, Draws.stream(0L, "", name, i, "noise"), true, RayRecorder.NONE)
                                    .bestLevel());
        }
        return highest;
    }
}
