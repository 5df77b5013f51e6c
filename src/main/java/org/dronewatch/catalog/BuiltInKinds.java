package org.dronewatch.catalog;

import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.drone.SoundEmission;
import org.dronewatch.drone.SteadyEmission;
import org.dronewatch.flight.Dive;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.LowApproach;
import org.dronewatch.flight.PopUp;
import org.dronewatch.flight.Recorded;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.Steered;
import org.dronewatch.flight.TerrainFollowing;
import org.dronewatch.flight.mission.Mission;
import org.dronewatch.flight.track.Track;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.DetectionFunction;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.setting.Kind;
import org.dronewatch.setting.KindGroup;

/**
 * The kinds of settings that belong to the library: sensors, detection functions, flights, emissions and propagation
 * models.
 */
public final class BuiltInKinds implements KindGroup {
    @Override
    public List<Kind<?>> kinds() {
        return Stream.of(sensors(), detectionFunctions(), flights(), emissions(), propagations())
                .<Kind<?>>flatMap(List::stream)
                .toList();
    }

    private static List<Kind<?>> sensors() {
        return List.of(
                sensor("camera", CameraSettings.class, "sees drones in daylight, by the pixels that they cover")
                        .withSynonyms("video", "optical", "eo"),
                sensor("acoustic", AcousticSettings.class, "hears drones: a microphone or an array of microphones")
                        .withSynonyms("microphone", "audio", "sound"),
                sensor("radar", RadarSettings.class, "detects the radar echoes of drones"),
                sensor("rf", RfSettings.class, "receives the radio signals of drones and their pilots")
                        .withSynonyms("radio", "receiver", "sdr"),
                sensor("thermal", ThermalSettings.class, "detects the heat of drones, by day and night")
                        .withSynonyms("infrared", "ir"));
    }

    private static List<Kind<?>> detectionFunctions() {
        return List.of(
                detection("pixel-threshold", PixelThreshold.class, "detects a drone that covers enough pixels"),
                detection(
                        "target-task",
                        TargetTask.class,
                        "detects a drone by Johnson's criteria, given contrast, light and blur"));
    }

    private static List<Kind<?>> flights() {
        return List.of(
                flight("hover", FlightPathSettings.Hover.class, "stays at one point"),
                flight("approach", FlightPathSettings.Approach.class, "flies straight from one point to another"),
                flight("inbound", FlightPathSettings.Inbound.class, "flies level and straight towards a target"),
                flight("waypoints", FlightPathSettings.Waypoints.class, "flies from waypoint to waypoint"),
                flight("route", RouteFlight.class, "flies straight legs without stopping, each at its own speed"),
                flight("glide", FlightPathSettings.Glide.class, "climbs under power, then glides without motors"),
                flight("orbit", FlightPathSettings.Orbit.class, "flies level circles around a point"),
                flight("terrain-following", TerrainFollowing.class, "flies low over the ground, from point to point"),
                flight("low-approach", LowApproach.class, "flies low over the ground towards a target"),
                flight("dive", Dive.class, "flies level towards a target, then dives onto it"),
                flight("pop-up", PopUp.class, "hovers behind cover, then rises"),
                flight("steered", Steered.class, "is steered by a program during the run"),
                flight("recorded", Recorded.class, "repeats a flight of an earlier run, from its flights.csv"),
                flight("mission", Mission.class, "flies a mission planned with QGroundControl, from its .plan file"),
                flight("track", Track.class, "repeats a real drone's flight, from a GPX track or a CSV log"));
    }

    private static List<Kind<?>> emissions() {
        return List.of(Kind.of(
                SoundEmission.class,
                "steady",
                SteadyEmission.class,
                "radiates the sound that the settings state, however the drone flies"));
    }

    private static List<Kind<?>> propagations() {
        return List.of(
                propagation(
                        "level-model",
                        LevelModel.class,
                        "traces rays that each carry the full sound level; calibrated, not physical"),
                propagation("energy-model", EnergyModel.class, "traces energy in octave bands; physical"));
    }

    private static Kind<?> sensor(String name, Class<? extends SensorSettings<?>> settings, String summary) {
        return Kind.of(SensorSettings.class, name, settings, summary);
    }

    private static Kind<?> detection(String name, Class<? extends DetectionFunction> settings, String summary) {
        return Kind.of(DetectionFunction.class, name, settings, summary);
    }

    private static Kind<?> flight(String name, Class<? extends FlightPathSettings> settings, String summary) {
        return Kind.of(FlightPathSettings.class, name, settings, summary);
    }

    private static Kind<?> propagation(String name, Class<? extends Propagation> settings, String summary) {
        return Kind.of(Propagation.class, name, settings, summary);
    }
}
