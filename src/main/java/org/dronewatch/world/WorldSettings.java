package org.dronewatch.world;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.Atmosphere;

/**
 * What a site is made of.
 *
 * @param models the meshes, merged into one; at least one
 * @param backgroundNoise sound pressure level of the background, -20 to 140 dB re 20 uPa
 * @param surfaces what the models' materials are to sound
 * @param atmosphere the air
 */
public record WorldSettings(
        List<ModelSettings> models,
        @In(Quantity.LEVEL) double backgroundNoise,
        SurfaceSettings surfaces,
        Atmosphere atmosphere) {
    /** Background of a quiet rural place, dB re 20 uPa. */
    public static final double QUIET = 30.0;

    private static final double LEAST_NOISE = -20.0;
    private static final double MOST_NOISE = 140.0;

    /**
     * Checks the limits and keeps its own list.
     *
     * @throws IllegalArgumentException when one does not hold
     */
    public WorldSettings {
        models = List.copyOf(Check.present("models", models));
        if (models.isEmpty()) {
            throw new IllegalArgumentException("models is empty: a world needs at least one");
        }
        Check.between("backgroundNoise", backgroundNoise, LEAST_NOISE, MOST_NOISE, Quantity.LEVEL);
        Check.present("surfaces", surfaces);
        Check.present("atmosphere", atmosphere);
    }

    /** A quiet world of one model. */
    public static WorldSettings of(ModelSettings model) {
        return new WorldSettings(List.of(model), QUIET, SurfaceSettings.DEFAULT, Atmosphere.STANDARD);
    }

    /** These settings with one more model: a house on the hill. */
    public WorldSettings withModel(ModelSettings model) {
        List<ModelSettings> more = new ArrayList<>(models);
        more.add(model);
        return new WorldSettings(more, backgroundNoise, surfaces, atmosphere);
    }

    /** These settings with another background, dB re 20 uPa. */
    public WorldSettings withBackgroundNoise(double level) {
        return new WorldSettings(models, level, surfaces, atmosphere);
    }

    /** These settings with other surfaces. */
    public WorldSettings withSurfaces(SurfaceSettings other) {
        return new WorldSettings(models, backgroundNoise, other, atmosphere);
    }

    /** These settings with other air. */
    public WorldSettings withAtmosphere(Atmosphere air) {
        return new WorldSettings(models, backgroundNoise, surfaces, air);
    }
}
