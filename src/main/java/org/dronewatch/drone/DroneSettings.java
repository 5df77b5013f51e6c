package org.dronewatch.drone;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.flight.Airframe;
import org.dronewatch.flight.Displaced;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.Swarm;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.Settings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.DroneSound;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.world.Ground;
import org.dronewatch.world.World;

/**
 * A drone: its shape, its flight, and its signatures for each kind of sensor.
 *
 * @param model its mesh, whose nose points to the model's north (y after loading) and whose origin is the drone's
 * @param flight its flight path
 * @param speed cruise speed, 0.001 to 400 m/s
 * @param acceleration maximum acceleration along the path, 0.001 to 10,000 m/s2
 * @param airframe type of airframe, which determines how it tilts
 * @param lean whether it tilts in flight as its type of airframe does: a multirotor into its acceleration, a fixed-wing
 *     into its turn; otherwise it stays level, unless its flight states an attitude
 * @param radar its radar signature
 * @param heat its thermal signature
 * @param radio how it is controlled, and which radio signals can be received
 * @param soundLevel source level for the simple attenuation model (the level model), dB on the calibrated scale of that
 *     model; only air and surfaces reduce it, not geometrical spreading, so it has no reference distance; 50 to 55 in
 *     the thesis on which this project is based
 * @param soundPowerLevel A-weighted sound power level for the energy model, dB re 1 pW; about 85 for a real quadrotor
 * @param glideReduction reduction of its sound level with the motors off, when only airflow is heard, 0 to 100 dB
 * @param sound name of the spectrum in the library's table, such as {@code c1-quadrotor}; if {@code spectrum} is set,
 *     any name that is not in the table; {@code soundPowerLevel} and {@code directivity} are set separately
 * @param spectrum a spectrum to use instead of one from the table: A-weighted levels of the octave bands relative to
 *     one another, as in the table; {@code soundPowerLevel} sets the overall level
 * @param directivity dependence of the radiated sound on elevation, for the energy model
 * @param tones the tones in its spectrum, which the narrow-band criterion of the energy model needs; omit it if there
 *     are none
 * @param emission how its sound depends on these settings and on its flight: steady, or a kind that another jar
 *     provides
 * @param performance known limits of its flight; if it is omitted, limits typical of its airframe apply, and flights
 *     are not checked against them
 * @param swarm number and formation of a swarm of such drones; omit it for a single drone
 * @param label its role, purpose and properties, for readers of the results; no sensor uses it
 */
public record DroneSettings(
        ModelSettings model,
        FlightPathSettings flight,
        @In(value = Quantity.SPEED, from = 0.001, to = 400) double speed,
        @In(value = Quantity.ACCELERATION, from = 0.001, to = 10_000) double acceleration,
        Airframe airframe,
        boolean lean,
        RadarSignature radar,
        HeatSignature heat,
        RadioLink radio,
        @In(value = Quantity.LEVEL, from = 0, to = 200) double soundLevel,
        @In(value = Quantity.LEVEL, from = 0, to = 200) double soundPowerLevel,
        @In(value = Quantity.LEVEL, from = 0, to = 100) double glideReduction,
        String sound,
        Optional<BandLevels> spectrum,
        Directivity directivity,
        @Minor Optional<RotorTones> tones,
        @Minor SoundEmission emission,
        @Minor Optional<FlightPerformance> performance,
        Optional<Swarm> swarm,
        ThreatLabel label)
        implements Settings<Drone> {
    /** The name of a drone that is created without one. */
    private static final String UNNAMED = "drone";

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public DroneSettings {
        Limits.check(
                DroneSettings.class,
                model,
                flight,
                speed,
                acceleration,
                airframe,
                lean,
                radar,
                heat,
                radio,
                soundLevel,
                soundPowerLevel,
                glideReduction,
                sound,
                spectrum,
                directivity,
                tones,
                emission,
                performance,
                swarm,
                label);
        spectrum.ifPresent(own -> Limits.check(
                BandLevels.class, Arrays.stream(own.toArray()).boxed().toArray()));
        if (model.crs().isPresent()) {
            throw new IllegalArgumentException(
                    "model.crs " + model.crs().get() + " applies to models of the site, not to that of a drone");
        }
        checkSound(sound, spectrum.isPresent());
        if (label.role() == ThreatLabel.Role.BIRD) {
            checkBird(radar, radio, Math.max(soundLevel, soundPowerLevel));
        }
    }

    /**
     * Checks that a bird has no properties that a bird cannot have: sensors know no labels, and would sense these
     * properties.
     */
    private static void checkBird(RadarSignature radar, RadioLink radio, double loudest) {
        if (radio.control() == RadioLink.Control.RADIO
                || loudest > 0.0
                || radar.rotorLevel().isPresent()) {
            throw new IllegalArgumentException(
                    "label.role bird: a bird has neither a transmitter nor motors nor rotors:"
                            + " radio.control must be autonomous, soundLevel and soundPowerLevel 0, and radar.rotorLevel omitted");
        }
    }

    /**
     * Checks the name of the sound. With a separate spectrum, a sound may have any name that is not in the table, or
     * none, in which case it keeps the default name. Without such a spectrum, the name must be in the table.
     */
    private static void checkSound(String name, boolean own) {
        if (own && name.isBlank()) {
            throw new IllegalArgumentException("sound '" + name + "' must be a name");
        }
        if (own
                && !name.equals(DroneSounds.SMALL_QUADROTOR)
                && DroneSounds.find(name).isPresent()) {
            throw new IllegalArgumentException("spectrum and sound '" + name
                    + "' are mutually exclusive, since the library's table has a spectrum of that name:"
                    + " omit one of them");
        }
        try {
            if (!own) {
                DroneSounds.get(name);
            }
        } catch (InputException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /**
     * A small quadrotor: cruise speed 5 m/s, acceleration 2.5 m/s2, radar cross-section 0.01 m2, source level 55 dB in
     * the level model, A-weighted sound power level 85 dB re 1 pW.
     */
    @Defaults({"model", "flight"})
    public static DroneSettings of(ModelSettings model, FlightPathSettings flight) {
        return new DroneSettings(
                model,
                flight,
                5.0,
                2.5,
                Airframe.MULTIROTOR,
                false,
                RadarSignature.DEFAULT,
                HeatSignature.DEFAULT,
                RadioLink.DEFAULT,
                55.0,
                85.0,
                30.0,
                DroneSounds.SMALL_QUADROTOR,
                Optional.empty(),
                Directivity.OMNIDIRECTIONAL,
                Optional.empty(),
                SteadyEmission.DEFAULT,
                Optional.empty(),
                Optional.empty(),
                ThreatLabel.DEFAULT);
    }

    /**
     * A bird, which sensors may mistake for a drone: inaudible (sound levels of 0 dB), and without a transmitter; its
     * temperature difference from the background is that of the default drone, since no figure for birds is available.
     *
     * @param speed speed in flight, m/s
     * @param crossSection mean radar cross-section, m2
     */
    public static DroneSettings bird(
            ModelSettings model, FlightPathSettings flight, double speed, double crossSection) {
        RadarSignature radar = RadarSignature.DEFAULT
                .withCrossSection(crossSection)
                .withFluctuation(RadarSignature.Fluctuation.SWERLING_1);
        Map<String, ?> silent = Map.of("soundLevel", 0.0, "soundPowerLevel", 0.0);
        DroneSettings unlabelled = of(model, flight)
                .withSpeed(speed)
                .withRadar(radar)
                .withRadio(RadioLink.DEFAULT.withControl(RadioLink.Control.AUTONOMOUS));
        return SettingsForm.with(unlabelled, silent).withLabel(ThreatLabel.BIRD);
    }

    /** Whether it is a bird rather than a drone, for scoring. */
    public boolean isBird() {
        return label.role() == ThreatLabel.Role.BIRD;
    }

    /** These settings with another mesh. */
    public DroneSettings withModel(ModelSettings other) {
        return SettingsForm.with(this, "model", other);
    }

    /** These settings with another flight. */
    public DroneSettings withFlight(FlightPathSettings other) {
        return SettingsForm.with(this, "flight", other);
    }

    /** These settings with another cruise speed, m/s. */
    public DroneSettings withSpeed(double metresPerSecond) {
        return SettingsForm.with(this, "speed", metresPerSecond);
    }

    /** These settings with another airframe. */
    public DroneSettings withAirframe(Airframe other) {
        return SettingsForm.with(this, "airframe", other);
    }

    /** These settings with a drone that tilts when it accelerates and turns, or that always stays level. */
    public DroneSettings withLean(boolean leaning) {
        return SettingsForm.with(this, "lean", leaning);
    }

    /** These settings with another radar cross-section, m2. */
    public DroneSettings withRadarCrossSection(double area) {
        return withRadar(radar.withCrossSection(area));
    }

    /** These settings with another radar signature. */
    public DroneSettings withRadar(RadarSignature other) {
        return SettingsForm.with(this, "radar", other);
    }

    /** These settings with another thermal signature. */
    public DroneSettings withHeat(HeatSignature other) {
        return SettingsForm.with(this, "heat", other);
    }

    /** These settings with another radio link. */
    public DroneSettings withRadio(RadioLink other) {
        return SettingsForm.with(this, "radio", other);
    }

    /** These settings with another level for the level model, dB. */
    public DroneSettings withSoundLevel(double level) {
        return SettingsForm.with(this, "soundLevel", level);
    }

    /**
     * These settings with the sound of another type of drone, both spectrum and sound power level: one from the
     * library's table, with its directivity if that was measured, or a sound that you define.
     *
     * @throws IllegalArgumentException if its sound power level is not between 0 and 200 dB, the relative level of a
     *     band is not between -200 and 200 dB, or a sound that you define has a name that is in the table
     */
    public DroneSettings withSound(DroneSound other) {
        boolean packaged = DroneSounds.find(other.name()).equals(Optional.of(other));
        Optional<BandLevels> own = packaged ? Optional.empty() : Optional.of(BandLevels.of(other.shape()));
        Optional<Directivity> measured = packaged ? DroneSounds.measuredDirectivity(other.name()) : Optional.empty();
        Map<String, Object> parts = Map.of(
                "soundPowerLevel", other.level(),
                "sound", other.name(),
                "spectrum", own,
                "directivity", measured.orElse(directivity));
        return SettingsForm.with(this, parts);
    }

    /**
     * These settings with a spectrum instead of one from the table, and the sound power level unchanged.
     *
     * @param shape A-weighted levels of the octave bands relative to one another, -200 to 200 dB
     */
    public DroneSettings withSpectrum(BandLevels shape) {
        Map<String, Object> parts = Map.of(
                "sound",
                DroneSounds.find(sound).isPresent() ? DroneSounds.SMALL_QUADROTOR : sound,
                "spectrum",
                Optional.of(Check.present("spectrum", shape)));
        return SettingsForm.with(this, parts);
    }

    /** These settings with another directivity. */
    public DroneSettings withDirectivity(Directivity other) {
        return SettingsForm.with(this, "directivity", other);
    }

    /** These settings with tones in the spectrum. */
    public DroneSettings withTones(RotorTones other) {
        return SettingsForm.with(this, "tones", Optional.of(Check.present("tones", other)));
    }

    /** These settings with another model of the emission. */
    public DroneSettings withEmission(SoundEmission other) {
        return SettingsForm.with(this, "emission", Check.present("emission", other));
    }

    /** These settings with a stated flight performance. */
    public DroneSettings withPerformance(FlightPerformance other) {
        return SettingsForm.with(this, "performance", Optional.of(Check.present("performance", other)));
    }

    /** These settings as a swarm. */
    public DroneSettings withSwarm(Swarm other) {
        return SettingsForm.with(this, "swarm", Optional.of(Check.present("swarm", other)));
    }

    /** These settings with another label. */
    public DroneSettings withLabel(ThreatLabel other) {
        return SettingsForm.with(this, "label", other);
    }

    /** The limits of the drone's flight: as stated, or else typical of its airframe and speed. */
    public FlightLimits flightLimits() {
        FlightLimits typical = FlightLimits.typical(airframe, speed);
        return performance.map(stated -> stated.orTypical(typical)).orElse(typical);
    }

    /** The individual drones: this one, or those of its swarm, the leader first. */
    public List<DroneSettings> members() {
        if (swarm.isEmpty()) {
            return List.of(this);
        }
        DroneSettings alone = SettingsForm.with(this, "swarm", Optional.empty());
        return swarm.get().offsets().stream()
                .map(offset -> alone.withFlight(new Displaced(flight, offset)))
                .toList();
    }

    /**
     * Sound power levels by octave band without weighting, dB re 1 pW, as radiated by a drone with steady emission and
     * its motors running.
     */
    public List<Double> soundPower() {
        return soundPower(soundPowerLevel);
    }

    /** As {@link #soundPower()}, but for another A-weighted sound power level, dB re 1 pW. */
    List<Double> soundPower(double level) {
        List<Double> shape = spectrum.map(
                        own -> Arrays.stream(own.toArray()).boxed().toList())
                .orElseGet(() -> DroneSounds.get(sound).shape());
        return DroneSound.octaves(shape, level);
    }

    /** These settings with another reduction of the sound level when the motors are off, dB. */
    public DroneSettings withGlideReduction(double decibels) {
        return SettingsForm.with(this, "glideReduction", decibels);
    }

    /**
     * The path of this drone, or of the leader of its swarm.
     *
     * @param ground the ground below, as {@link World#newGround()} returns it
     * @throws IllegalArgumentException when the flight follows the ground and there is none
     */
    public FlightPath createFlight(Ground ground) {
        return leaning(flight.create(speed, acceleration, ground));
    }

    /** A path with this drone's tilt added, if it tilts. */
    public FlightPath leaning(FlightPath path) {
        return lean ? airframe.leaning(path) : path;
    }

    /**
     * A drone named {@code drone}, whose model is in the working directory: as {@link #create(String, Path)}.
     *
     * @throws IllegalArgumentException when the flight follows the ground
     * @throws org.dronewatch.setting.InputException when the model cannot be loaded
     */
    @Override
    public Drone create() {
        return create(UNNAMED, Path.of(""));
    }

    /**
     * A drone with these settings at the start of its path, which must not follow the ground.
     *
     * @param id its name
     * @param tree tree over its loaded mesh
     * @throws IllegalArgumentException when the flight follows the ground
     */
    public Drone create(String id, KDTree tree) {
        return new Drone(id, this, tree).at(createFlight(Ground.NONE).at(0.0));
    }

    /**
     * A drone with these settings at the start of its path, which must not follow the ground; loads the mesh and builds
     * its tree.
     *
     * @param id its name
     * @param directory directory against which a relative model path is resolved
     * @throws IllegalArgumentException when the flight follows the ground
     * @throws org.dronewatch.setting.InputException when the model cannot be loaded
     */
    public Drone create(String id, Path directory) {
        return create(id, KDTree.of(new ModelLoader(directory).load(model).mesh()));
    }
}
