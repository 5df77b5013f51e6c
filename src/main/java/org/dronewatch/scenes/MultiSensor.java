package org.dronewatch.scenes;

import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Inbound;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.camera.CameraSettings;

/**
 * The range at which a quadrotor is detected from a house on a hill. The house has twelve cameras, three at each corner
 * of its roof, and a microphone in the middle; the drone approaches from the north at 5 m/s. Direction, height, sound
 * level and model of the drone can be changed with {@code --set}: {@code drones.quadrotor.flight.bearing},
 * {@code ...flight.height}, {@code ...soundLevel}, {@code ...model.file}.
 */
public final class MultiSensor extends Scene {
    /** The middle of the ground floor, on the hill's level top. */
    private static final Position HOUSE = new Position(0, 0, 132);

    private static final Position MICROPHONE = HOUSE.plus(new Position(0, 0, 13));

    /** A mast on each corner of the parapet. */
    private static final double EAST = 12.0;

    private static final double NORTH = 8.0;
    private static final double MAST = 11.5;

    /** The middle camera of a corner looks outwards between two sides, the others to both sides of it. */
    private static final double ASIDE = 60.0;

    private static final double UP = 5.0;

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));
        loadWorld(loadPackaged("house.obj").withPosition(HOUSE));
        setBackgroundNoise(32.0);
        surface("grass", "grass_turf");
        surface("dry_meadow", "pasture_uncompacted");
        surface("forest_floor", "forest_floor");
        surface("rock", "limestone");
        surface("concrete", "concrete_rough");
        surface("plaster", "plaster_lime");
        surface("brick", "brick_rough");
        surface("wood", "wooden_door");
        surface("glass", "glass_window");
        surface("metal", "metal_sheet");
        surface("gravel", "gravel_road");

        add(
                "quadrotor",
                DroneSettings.of(loadPackaged("quadrotor.obj"), new Inbound(MICROPHONE, 0.0, 0.0, 180.0, 15.0))
                        .withSpeed(5.0)
                        .withSoundLevel(52.0));
        addCorner("north-east", EAST, NORTH, 45.0);
        addCorner("south-east", EAST, -NORTH, 135.0);
        addCorner("south-west", -EAST, -NORTH, 225.0);
        addCorner("north-west", -EAST, NORTH, 315.0);
        add("microphone", AcousticSettings.at(MICROPHONE).withPropagation(LevelModel.DEFAULT.withRays(20, 20)));

        setRun(RunSettings.DEFAULT.withDuration(33.0));
    }

    private void addCorner(String corner, double east, double north, double outwards) {
        for (int i = 0; i < 3; i++) {
            double azimuth = Math.toRadians(outwards + (i - 1) * ASIDE);
            add(
                    corner + "-" + (i + 1),
                    CameraSettings.at(HOUSE.plus(new Position(east, north, MAST)))
                            .withAim(new Aim.Direction(azimuth, Math.toRadians(UP))));
        }
    }

    /** The range at which the air has attenuated the drone's sound to the detection threshold. */
    @Override
    public OptionalDouble expectedRange(SceneSettings settings, String sensor) {
        if (settings.sensors().get(sensor) instanceof AcousticSettings microphone
                && microphone.propagation() instanceof LevelModel model
                && settings.drones().get("quadrotor").emission().isStatedBySettings()) {
            double margin = settings.drones().get("quadrotor").soundLevel()
                    - microphone.detectionLevel(settings.world().backgroundNoise());
            return OptionalDouble.of(margin / model.attenuation());
        }
        return OptionalDouble.empty();
    }
}
