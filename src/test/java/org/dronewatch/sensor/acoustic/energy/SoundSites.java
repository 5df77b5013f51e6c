package org.dronewatch.sensor.acoustic.energy;

import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;

/**
 * Sites of different kinds, outdoors and indoors, with their quadrotor, which sounds alike in all directions.
 *
 * @param world its surfaces and air
 * @param power sound power level of the drone in each band, dB
 */
record SoundSites(World world, List<Double> power) {
    /** A house on a hill, of the packaged models. */
    static SoundSites hill() {
        return of(Path.of("scenes/multi-sensor.yaml"));
    }

    /** A church, of the packaged models. */
    static SoundSites church() {
        return of(Path.of("scenes/closed-space.yaml"));
    }

    /** Two houses of brick on asphalt. */
    static SoundSites canyon() {
        return of(resource("canyon.yaml"));
    }

    /** A house without openings. */
    static SoundSites sealed() {
        return of(resource("sealed.yaml"));
    }

    /** A room of 10 x 8 x 4 m whose surfaces absorb and scatter a part. */
    static SoundSites room() {
        return new SoundSites(
                Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3)),
                Collections.nCopies(OctaveBands.COUNT, Sites.LW));
    }

    /** Waves of terrain, 4 m high, which scatter half of what they reflect. */
    static SoundSites waves() {
        return new SoundSites(
                Sites.world(
                        Sites.terrain(120, 6, (x, y) -> 2 * Math.sin(x / 15) * Math.cos(y / 20)),
                        SurfaceMaterial.uniform("meadow", 0.4, 0.5)),
                Collections.nCopies(OctaveBands.COUNT, Sites.LW));
    }

    private static Path resource(String name) {
        try {
            return Path.of(SoundSites.class.getResource(name).toURI());
        } catch (URISyntaxException e) {
            throw new AssertionError(e);
        }
    }

    private static SoundSites of(Path file) {
        SceneFile scene = new SceneFile(file);
        SceneSettings settings = scene.describe();
        ModelCache models = new ModelCache(scene.directory(), note -> {});
        settings.individualDrones().values().forEach(drone -> models.read(drone.model()));
        Stage stage = new Stage(settings, models, 1);
        Drone drone = stage.dronesAt(0).get(0);
        return new SoundSites(stage.world(), drone.soundPower());
    }

    /** The drone's sound from a place. */
    SoundSource drone(Position place) {
        return new SoundSource(place, power, Directivity.OMNIDIRECTIONAL);
    }

    /** What a microphone hears by the default settings. */
    EnergyTracer microphone(Position place) {
        return microphone(EnergyModel.DEFAULT, place);
    }

    /** What a microphone hears by other settings. */
    EnergyTracer microphone(EnergyModel model, Position place) {
        return new EnergyTracer(model, place, RADIUS, world);
    }

    /** Of the sphere in which rays are counted, as the settings of a microphone have it, m. */
    private static final double RADIUS = 0.5;
}
