package org.dronewatch.sensor.radar;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.CrossingBlind;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.AzimuthSpan;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.NoiseAlarming;
import org.dronewatch.sensor.radio.GroundReflecting;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;

/**
 * A radar on a fixed mount. Without a {@code beam}, it has the same gain throughout its field of view.
 *
 * @param position position of its antenna, m
 * @param aim direction of the centre of its field of view; the elevation is the tilt of its mount
 * @param maxTilt maximum tilt of its mount, up or down, which limits the elevation of the aim, 0 to pi/2 rad
 * @param azimuthWidth horizontal width of its field of view, pi/18000 (0.01 degrees) to 2 pi rad
 * @param elevationWidth vertical width of its field of view, pi/18000 (0.01 degrees) to pi rad
 * @param minRange minimum range, within which drones are masked by the radar's own pulse, 0 to 1,000,000 m
 * @param maxRange maximum range, beyond which drones are not detected, above 0 and at most 1,000,000 m
 * @param minSpeed minimum radial speed, below which drones are rejected as ground clutter, 0 to 10,000 m/s; not used
 *     with a notch
 * @param maxSpeed maximum radial speed, above which drones are not detected, above 0 and at most 10,000 m/s
 * @param rate scans per second, above 0, Hz
 * @param frequency carrier frequency, 1e9 to 1e12 Hz (1 to 1000 GHz)
 * @param polarisation polarisation; it affects attenuation by rain and reflection from the ground
 * @param budget link budget, which gives the signal-to-noise ratio of an echo
 * @param detection detection function: the signal-to-noise ratio at which an echo is detected
 * @param accuracy accuracy of the positions that it measures
 * @param groundReflection ground whose reflection interferes with the direct wave, in both directions, if the reflected
 *     path lies within the field of view of the radar; none by default. The polarisation must then be horizontal or
 *     vertical
 * @param beam shape of its beam; without one, the gain is the same throughout its field of view
 * @param diffraction whether the wave is diffracted around edges of terrain and buildings, in both directions, as for a
 *     radio receiver; otherwise the echo is scaled by the visible fraction of the drone
 * @param clutter echoes from the ground and from rain that compete with those of drones; none by default. It needs a
 *     beam, whose azimuthBeamwidth is the width of a resolution cell
 * @param notch a Doppler filter that rejects stationary echoes, in place of minSpeed; none by default
 * @param falseAlarms how often noise exceeds the radar's threshold; unless set, the rate is unknown, and no false
 *     alarms are simulated
 */
public record RadarSettings(
        Position position,
        Aim aim,
        @Minor @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 2) double maxTilt,
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = 2 * Math.PI) double azimuthWidth,
        @In(value = Quantity.ANGLE, from = In.NARROWEST, to = Math.PI) double elevationWidth,
        @In(value = Quantity.LENGTH, from = 0, to = 1e6) double minRange,
        @In(value = Quantity.LENGTH, above = 0, to = 1e6) double maxRange,
        @In(value = Quantity.SPEED, from = 0, to = 10_000) double minSpeed,
        @In(value = Quantity.SPEED, above = 0, to = 10_000) double maxSpeed,
        @In(value = Quantity.FREQUENCY, above = 0, to = 1000) double rate,
        @In(value = Quantity.FREQUENCY, from = 1e9, to = 1e12) double frequency,
        Rain.Polarisation polarisation,
        LinkBudget budget,
        RadarDetection detection,
        Accuracy accuracy,
        @Minor Optional<ReflectingGround> groundReflection,
        @Minor Optional<BeamPattern> beam,
        @Minor boolean diffraction,
        @Minor Optional<Clutter> clutter,
        @Minor Optional<DopplerFilter> notch,
        @Minor Optional<RadarFalseAlarms> falseAlarms)
        implements SensorSettings<RadarSensor>,
                Aimed,
                Outlined,
                DirectionFinding,
                NoiseAlarming,
                GroundReflecting,
                CrossingBlind {

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public RadarSettings {
        Limits.check(
                RadarSettings.class,
                position,
                aim,
                maxTilt,
                azimuthWidth,
                elevationWidth,
                minRange,
                maxRange,
                minSpeed,
                maxSpeed,
                rate,
                frequency,
                polarisation,
                budget,
                detection,
                accuracy,
                groundReflection,
                beam,
                diffraction,
                clutter,
                notch,
                falseAlarms);
        if (groundReflection.isPresent() && polarisation == Rain.Polarisation.CIRCULAR) {
            throw new IllegalArgumentException(
                    "groundReflection needs the polarisation horizontal or vertical, not circular");
        }
        if (clutter.isPresent() && beam.isEmpty()) {
            throw new IllegalArgumentException(
                    "clutter needs a beam, whose azimuthBeamwidth is the width of a resolution cell");
        }
        clutter.ifPresent(one -> one.checkBandwidth(budget));
        checkTilt(tilt(aim.from(position)), maxTilt);
        if (minRange >= maxRange) {
            throw new IllegalArgumentException("minRange " + minRange + " m must be below maxRange " + maxRange + " m");
        }
        if (minSpeed >= maxSpeed) {
            throw new IllegalArgumentException(
                    "minSpeed " + minSpeed + " m/s must be below maxSpeed " + maxSpeed + " m/s");
        }
        if (falseAlarms.isPresent()) {
            double slowest = notch.isPresent() ? 0.0 : minSpeed;
            ResolutionCells cells = new ResolutionCells(
                    azimuthWidth, elevationWidth, minRange, maxRange, slowest, maxSpeed, frequency, beam);
            falseAlarms.get().rate(cells, budget, detection, rate);
        }
    }

    /** The cells of a scan. */
    ResolutionCells cells() {
        return new ResolutionCells(
                azimuthWidth, elevationWidth, minRange, maxRange, slowest(), maxSpeed, frequency, beam);
    }

    /**
     * The least radial speed at which the radar looks for drones, m/s: 0 with a notch, which rejects slow drones
     * itself.
     */
    double slowest() {
        return notch.isPresent() ? 0.0 : minSpeed;
    }

    /** The greatest radial speed at which the radar looks for drones, m/s. */
    double fastest() {
        return Math.min(maxSpeed, budget.migrationSpeed());
    }

    @Override
    public double response(double radialSpeed) {
        double speed = Math.abs(radialSpeed);
        boolean isLookedAt = speed >= slowest() && speed <= fastest();
        return isLookedAt ? notch.map(filter -> filter.response(radialSpeed)).orElse(1.0) : 0.0;
    }

    private static void checkTilt(double tilt, double most) {
        // Apart from rounding, an aim at a point may lie exactly at the limit.
        if (Math.abs(tilt) > most + 1e-9) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "aim: elevation %s must be %s to %s, the limits of its mount (maxTilt)",
                    Quantity.ANGLE.inWords(tilt),
                    Quantity.ANGLE.inWords(-most),
                    Quantity.ANGLE.inWords(most)));
        }
    }

    private static double tilt(Position axis) {
        return Math.atan2(axis.z(), Math.hypot(axis.x(), axis.y()));
    }

    /**
     * A radar that scans through 360 degrees once per second, over 20 degrees of elevation centred on the horizon, at
     * 10 GHz with horizontal polarisation, from 20 m to 10 km, for radial speeds from 1 to 200 m/s, with a fixed
     * threshold of 15 dB; its position errors are 5 m and one degree. Whether a look detects a drone does not depend on
     * chance, unless {@link #withDetection} sets a probabilistic detection function. For a
     * {@link LinkBudget.DataSheet}, choose {@link RadarDetection.Chance}, or the threshold that the data sheet implies.
     */
    @Defaults({"position", "budget"})
    public static RadarSettings at(Position position, LinkBudget budget) {
        return new RadarSettings(
                position,
                Aim.Direction.DEFAULT,
                0.5 * Math.PI,
                2.0 * Math.PI,
                Math.toRadians(20.0),
                20.0,
                10_000.0,
                1.0,
                200.0,
                1.0,
                10e9,
                Rain.Polarisation.HORIZONTAL,
                budget,
                RadarDetection.FixedThreshold.DEFAULT,
                Accuracy.DEFAULT,
                Optional.empty(),
                Optional.empty(),
                false,
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    @Override
    public RadarSettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    @Override
    public boolean isDirectional() {
        return azimuthWidth < 2.0 * Math.PI;
    }

    @Override
    public RadarSettings withAim(Aim other) {
        return SettingsForm.with(this, "aim", other);
    }

    /** These settings with another limit of the tilt, rad. */
    public RadarSettings withMaxTilt(double angle) {
        return SettingsForm.with(this, "maxTilt", angle);
    }

    /** These settings with another horizontal and vertical width of the field of view, rad. */
    public RadarSettings withFieldOfView(double azimuth, double elevation) {
        return SettingsForm.with(this, Map.of("azimuthWidth", azimuth, "elevationWidth", elevation));
    }

    /** These settings with other minimum and maximum ranges, m. */
    public RadarSettings withRanges(double least, double most) {
        return SettingsForm.with(this, Map.of("minRange", least, "maxRange", most));
    }

    /** These settings with other minimum and maximum radial speeds, m/s. */
    public RadarSettings withSpeeds(double least, double most) {
        return SettingsForm.with(this, Map.of("minSpeed", least, "maxSpeed", most));
    }

    /** These settings with another number of scans per second, Hz. */
    public RadarSettings withRate(double scansPerSecond) {
        return SettingsForm.with(this, "rate", scansPerSecond);
    }

    /** These settings with another carrier frequency, Hz, and polarisation. */
    public RadarSettings withWave(double hertz, Rain.Polarisation other) {
        return SettingsForm.with(this, Map.of("frequency", hertz, "polarisation", other));
    }

    /** These settings with another link budget. */
    public RadarSettings withBudget(LinkBudget other) {
        return SettingsForm.with(this, "budget", other);
    }

    /** These settings with another detection function. */
    public RadarSettings withDetection(RadarDetection other) {
        return SettingsForm.with(this, "detection", other);
    }

    /** These settings with another accuracy. */
    public RadarSettings withAccuracy(Accuracy other) {
        return SettingsForm.with(this, "accuracy", other);
    }

    /** These settings with reflecting ground. */
    public RadarSettings withGroundReflection(ReflectingGround ground) {
        return SettingsForm.with(this, "groundReflection", Optional.of(ground));
    }

    /** These settings with a beam. */
    public RadarSettings withBeam(BeamPattern pattern) {
        return SettingsForm.with(this, "beam", Optional.of(pattern));
    }

    /** These settings with or without diffraction around edges. */
    public RadarSettings withDiffraction(boolean roundEdges) {
        return SettingsForm.with(this, "diffraction", roundEdges);
    }

    /** These settings with clutter, which requires a beam. */
    public RadarSettings withClutter(Clutter other) {
        return SettingsForm.with(this, "clutter", Optional.of(other));
    }

    /** {@inheritDoc} A radar that rejects no radial speed, however low, is not blind to crossing drones. */
    @Override
    public <C> Optional<C> as(Class<C> capability) {
        boolean rejectsSlow = notch.isPresent() || minSpeed > 0.0;
        return capability == CrossingBlind.class && !rejectsSlow
                ? Optional.empty()
                : SensorSettings.super.as(capability);
    }

    /** These settings with a Doppler filter that rejects stationary echoes, in place of a minimum radial speed. */
    public RadarSettings withNotch(DopplerFilter filter) {
        return SettingsForm.with(this, "notch", Optional.of(filter));
    }

    /** These settings with false alarms. */
    public RadarSettings withFalseAlarms(RadarFalseAlarms noise) {
        return SettingsForm.with(this, "falseAlarms", Optional.of(noise));
    }

    @Override
    public double falseAlarmProbability(double perHour) {
        double cells = falseAlarms.orElse(RadarFalseAlarms.DEFAULT).cells(cells(), budget);
        return perHour / (3600.0 * rate * cells);
    }

    @Override
    public String falseAlarmSetting() {
        return detection instanceof RadarDetection.Chance ? "detection.falseAlarm" : "falseAlarms.probability";
    }

    @Override
    public Optional<FalseAlarmRate> falseAlarmRate() {
        return falseAlarms.map(noise -> noise.rate(cells(), budget, detection, rate));
    }

    /** {@inheritDoc} The numbers represent range, azimuth and elevation. */
    @Override
    public int dimensions() {
        return 3;
    }

    @Override
    public Optional<Sighting> falseSighting(double u, double v, double w) {
        return Optional.of(new NoiseField(position, outline(), accuracy).at(u, v, w));
    }

    /** {@inheritDoc} Its value is the signal-to-noise ratio that noise alone appears to have. */
    @Override
    public Reading falseReading(World world, double excess) {
        return detection.noise(excess);
    }

    @Override
    public Optional<AzimuthSpan> falseBearings() {
        return Optional.of(new AzimuthSpan(outline().azimuth(), azimuthWidth));
    }

    /** The field of view of the radar. */
    @Override
    public Outline.Sector outline() {
        Position axis = aim.from(position);
        return new Outline.Sector(
                Math.atan2(axis.x(), axis.y()), tilt(axis), azimuthWidth, elevationWidth, minRange, maxRange);
    }

    /**
     * {@inheritDoc} The warnings concern a gain that the beam cannot have, a scan that is too fast for its beams, and a
     * fixed threshold that does not give the range of the data sheet. Each is checked only if the budget states the
     * values required.
     */
    @Override
    public List<String> advice() {
        return RadarAdvice.on(this);
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring(
                        clutter.isPresent() ? "signal-to-clutter-plus-noise ratio" : "signal-to-noise ratio")
                .withWeakness("echo too weak")
                .withLeavesOut(leavesOut());
    }

    /** A sentence for each effect, so that radars with different settings do not contradict each other. */
    private String[] leavesOut() {
        return Stream.of(
                        clutter.isPresent()
                                ? ""
                                : "For radars without 'clutter', no echoes of the ground or of rain compete with those of"
                                        + " drones.",
                        notch.isPresent()
                                ? ""
                                : "For radars without a 'notch', the micro-Doppler of rotors is not modelled.",
                        "The wingbeats of birds do not change the echoes that radars receive.")
                .filter(sentence -> !sentence.isEmpty())
                .toArray(String[]::new);
    }

    @Override
    public String kind() {
        return "radar";
    }

    @Override
    public RadarSensor create() {
        return new RadarSensor(this);
    }
}
