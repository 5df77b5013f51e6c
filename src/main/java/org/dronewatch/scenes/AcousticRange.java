package org.dronewatch.scenes;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweepAxis;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;

/**
 * The range at which a microphone hears a small quadrotor. The microphone is on a hill; the drone approaches from the
 * north at 5 m/s. The flight is repeated for five levels of background noise.
 */
public final class AcousticRange extends Scene {
    private static final Position MICROPHONE = new Position(0, 0, 144);

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));
        surface("grass", "grass_turf");
        surface("dry_meadow", "pasture_uncompacted");
        surface("forest_floor", "forest_floor");
        surface("rock", "limestone");

        Position far = MICROPHONE.plus(new Position(0, 520, 0));
        Position near = MICROPHONE.plus(new Position(0, 60, 0));
        add(
                "quadrotor",
                DroneSettings.of(loadPackaged("quadrotor.obj"), new Approach(far, near))
                        .withSpeed(5.0)
                        .withSoundLevel(50.0));
        add(
                "microphone",
                AcousticSettings.at(MICROPHONE).withRate(10.0).withPropagation(LevelModel.DEFAULT.withRays(20, 20)));

        setRun(RunSettings.DEFAULT.withDuration(92.0));
        sweep("world.backgroundNoise", 30.0, 25.0, 20.0, 15.0, 10.0);
    }

    /**
     * The range at which the air has attenuated the drone's sound to the detection threshold, if that sound is steady.
     */
    @Override
    public OptionalDouble expectedRange(SceneSettings settings, String sensor) {
        if (!(settings.sensors().get(sensor) instanceof AcousticSettings microphone)) {
            return OptionalDouble.empty();
        }
        DroneSettings drone = settings.drones().get("quadrotor");
        double margin =
                drone.soundLevel() - microphone.detectionLevel(settings.world().backgroundNoise());
        return microphone.propagation() instanceof LevelModel model
                        && drone.emission().isStatedBySettings()
                ? OptionalDouble.of(margin / model.attenuation())
                : OptionalDouble.empty();
    }

    @Override
    public Optional<SweepAxis> sweepAxis() {
        return Optional.of(new SweepAxis(
                "level of the drone above the background [dB]",
                settings -> loudness(settings) - settings.world().backgroundNoise()));
    }

    /** The drone's level in the chosen propagation model, dB. */
    private static double loudness(SceneSettings settings) {
        DroneSettings drone = settings.drones().get("quadrotor");
        boolean physical = settings.sensors().get("microphone") instanceof AcousticSettings microphone
                && microphone.propagation() instanceof EnergyModel;
        return physical ? drone.soundPowerLevel() : drone.soundLevel();
    }
}
