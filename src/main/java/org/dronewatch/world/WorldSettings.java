package org.dronewatch.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.bvh.TracingSettings;
import org.dronewatch.geo.Origin;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.terrain.TerrainSettings;

/**
 * The site: its models, its surfaces, and the conditions in which sensors work.
 *
 * @param models the meshes, merged into one with the terrain and the buildings; at least one, unless there is terrain
 *     or there are buildings
 * @param terrain the ground of a real place, from elevation files; omit it if there is none. It needs the origin
 * @param buildings the buildings of a real place, from a map; omit it if there are none. They need the origin
 * @param backgroundNoise sound pressure level of the background, A-weighted, -20 to 140 dB re 20 uPa
 * @param noiseShape spectrum of the background: the levels of the octave bands relative to one another, without
 *     weighting, dB
 * @param noiseSources sources of noise on the site in addition to the background, by name
 * @param surfaces acoustic surfaces of the models' materials
 * @param atmosphere the air
 * @param rain rain rate, 0 to 500 mm/h; it affects radars and cameras with a target task, but not sound
 * @param light visibility, daylight and turbulence
 * @param origin geographic position of the scene's origin (WGS 84); omit it if unknown; if given, a run writes maps and
 *     records the origin in {@code result.json}
 * @param tracing method of tracing rays; it affects speed, not results
 */
public record WorldSettings(
        List<ModelSettings> models,
        Optional<TerrainSettings> terrain,
        Optional<BuildingSettings> buildings,
        @In(value = Quantity.LEVEL, from = -20, to = 140) double backgroundNoise,
        BandLevels noiseShape,
        Map<String, NoiseSource> noiseSources,
        SurfaceSettings surfaces,
        Atmosphere atmosphere,
        @In(value = Quantity.PRECIPITATION, from = 0, to = 500) double rain,
        Light light,
        Optional<Origin> origin,
        TracingSettings tracing) {
    /** Background of a quiet rural site, dB re 20 uPa. */
    public static final double QUIET = 30.0;

    /** A quiet world without models yet. */
    @Defaults
    public static final WorldSettings EMPTY = of(List.of());

    /**
     * Checks the limits and copies the list. That the world is not empty is checked with the whole scene.
     *
     * @throws IllegalArgumentException if a value is out of range, or a surface has an unknown name
     */
    public WorldSettings {
        Limits.check(
                WorldSettings.class,
                models,
                terrain,
                buildings,
                backgroundNoise,
                noiseShape,
                noiseSources,
                surfaces,
                atmosphere,
                rain,
                light,
                origin,
                tracing);
        try {
            surfaces.checkNames();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("surfaces." + e.getMessage(), e);
        }
        models = List.copyOf(models);
        noiseSources = Collections.unmodifiableMap(new LinkedHashMap<>(noiseSources));
    }

    /** A quiet world with one model. */
    public static WorldSettings of(ModelSettings model) {
        return of(List.of(model));
    }

    /** A quiet world with several models, merged into one. */
    public static WorldSettings of(List<ModelSettings> models) {
        return new WorldSettings(
                models,
                Optional.empty(),
                Optional.empty(),
                QUIET,
                BackgroundNoise.FALLING,
                Map.of(),
                SurfaceSettings.DEFAULT,
                Atmosphere.STANDARD,
                0.0,
                Light.DAY,
                Optional.empty(),
                TracingSettings.DEFAULT);
    }

    /** These settings with one more model, such as a house on a hill. */
    public WorldSettings withModel(ModelSettings model) {
        List<ModelSettings> more = new ArrayList<>(models);
        more.add(model);
        return SettingsForm.with(this, "models", more);
    }

    /** These settings with the ground of a real place; they need an {@link #origin}, too. */
    public WorldSettings withTerrain(TerrainSettings ground) {
        return SettingsForm.with(this, "terrain", Optional.of(ground));
    }

    /** These settings with the buildings of a real place; they need an {@link #origin}, too. */
    public WorldSettings withBuildings(BuildingSettings houses) {
        return SettingsForm.with(this, "buildings", Optional.of(houses));
    }

    /** These settings with another level of the background, A-weighted, dB re 20 uPa. */
    public WorldSettings withBackgroundNoise(double level) {
        return SettingsForm.with(this, "backgroundNoise", level);
    }

    /** These settings with another background noise. */
    public WorldSettings withBackgroundNoise(BackgroundNoise noise) {
        return SettingsForm.with(this, Map.of("backgroundNoise", noise.level(), "noiseShape", noise.shape()));
    }

    /** The background noise. */
    public BackgroundNoise noise() {
        return new BackgroundNoise(backgroundNoise, noiseShape);
    }

    /** These settings with one more noise source. */
    public WorldSettings withNoiseSource(String name, NoiseSource source) {
        Map<String, NoiseSource> more = new LinkedHashMap<>(noiseSources);
        more.put(name, source);
        return SettingsForm.with(this, "noiseSources", more);
    }

    /** These settings with other surfaces. */
    public WorldSettings withSurfaces(SurfaceSettings other) {
        return SettingsForm.with(this, "surfaces", other);
    }

    /** These settings with another atmosphere. */
    public WorldSettings withAtmosphere(Atmosphere air) {
        return SettingsForm.with(this, "atmosphere", air);
    }

    /** These settings with this geographic origin. */
    public WorldSettings withOrigin(Origin other) {
        return SettingsForm.with(this, "origin", Optional.of(other));
    }

    /** These settings with another method of tracing rays. */
    public WorldSettings withTracing(TracingSettings other) {
        return SettingsForm.with(this, "tracing", other);
    }

    /** These settings with another rain rate, mm/h. */
    public WorldSettings withRain(double millimetresPerHour) {
        return SettingsForm.with(this, "rain", millimetresPerHour);
    }

    /** The weather and light that these settings state. */
    public Weather weather() {
        return new Weather(rain, atmosphere.wind().speed(), light.visibility(), light.illuminance());
    }

    /** These settings with other light. */
    public WorldSettings withLight(Light other) {
        return SettingsForm.with(this, "light", other);
    }
}
