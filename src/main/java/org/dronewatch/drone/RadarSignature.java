package org.dronewatch.drone;

import java.util.List;
import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A drone's radar signature.
 *
 * @param crossSection mean radar cross-section, 1e-9 to 1e6 m2
 * @param fluctuation fluctuation of the cross-section: none (steady), from look to look (swerling-1 and swerling-3),
 *     or from pulse to pulse (swerling-2 and swerling-4)
 * @param aspects aspect-dependent cross-section relative to the mean, dB: values at equal steps of azimuth, clockwise
 *     from the nose as seen from above; 1 to 360 of them, a single one if the cross-section is the same for all aspects
 * @param spread standard deviation in decibels of a cross-section that is log-normally distributed from look to look,
 *     above 0 and at most 20 dB; omit it to use {@code fluctuation}
 * @param droneClass a class of drones, which sets {@code crossSection} and {@code spread}; omit it to state these
 *     two yourself
 * @param rotorLevel level of its rotors' echo below that of its body, 0 to 100 dB: while its motors run, the
 *     rotors' part of the cross-section passes a radar's {@code notch} even when the drone hovers; omit it for rotors
 *     without an echo
 */
public record RadarSignature(
        @In(value = Quantity.AREA, from = 1e-9, to = 1e6) double crossSection,
        Fluctuation fluctuation,
        @In(value = Quantity.LEVEL, from = -100, to = 100) List<Double> aspects,
        @Minor @In(value = Quantity.LEVEL, above = 0, to = 20) Optional<Double> spread,
        @Minor Optional<DroneClass> droneClass,
        @Minor @In(value = Quantity.LEVEL, from = 0, to = 100) Optional<Double> rotorLevel) {
    private static final double USUAL_AREA = 0.01;

    /**
     * The value usual in data sheets: 0.01 m2, steady, the same for all aspects. That is less than the mean
     * cross-section of any of five measured drones, from the Phantom 3 to the Matrice 600: -8.1 to -19.1 dBsm at 24 GHz
     * (IEICE Communications Express 9, 2020). The echo of a real drone also fluctuates, as that of a {@link DroneClass}
     * does.
     */
    @Defaults
    public static final RadarSignature DEFAULT = new RadarSignature(
            USUAL_AREA, Fluctuation.STEADY, List.of(0.0), Optional.empty(), Optional.empty(), Optional.empty());

    private static final int MAX_ASPECTS = 360;

    /**
     * The fluctuation of a cross-section: Swerling's cases (P. Swerling, "Probability of detection for fluctuating
     * targets", IRE Transactions on Information Theory 6, 1960). Cases 2 and 4 differ from 1 and 3 only where a radar
     * integrates several pulses.
     */
    public enum Fluctuation {
        /** No fluctuation: Swerling's case 0. */
        STEADY,
        /** Many similar scatterers, fluctuating from look to look: exponentially distributed, case 1. */
        SWERLING_1,
        /** Many similar scatterers, fluctuating from pulse to pulse: exponentially distributed, case 2. */
        SWERLING_2,
        /**
         * One large scatterer with many small ones, fluctuating from look to look: chi-square with four degrees of
         * freedom, case 3.
         */
        SWERLING_3,
        /** One large scatterer with many small ones, fluctuating from pulse to pulse: case 4. */
        SWERLING_4
    }

    /**
     * Checks the limits and copies the list.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public RadarSignature {
        Limits.check(RadarSignature.class, crossSection, fluctuation, aspects, spread, droneClass, rotorLevel);
        aspects = List.copyOf(aspects);
        if (aspects.isEmpty() || aspects.size() > MAX_ASPECTS) {
            throw new IllegalArgumentException(
                    "aspects has " + aspects.size() + " values but must have 1 to " + MAX_ASPECTS);
        }
        if (spread.isPresent() && fluctuation != Fluctuation.STEADY) {
            throw twoAnswers("spread", "fluctuation");
        }
        if (droneClass.isPresent()) {
            checkApart(crossSection != USUAL_AREA, "crossSection");
            checkApart(fluctuation != Fluctuation.STEADY, "fluctuation");
            checkApart(spread.isPresent(), "spread");
        }
    }

    private static void checkApart(boolean isSet, String setting) {
        if (isSet) {
            throw twoAnswers("droneClass", setting);
        }
    }

    private static IllegalArgumentException twoAnswers(String one, String other) {
        return new IllegalArgumentException(one + " and " + other + " are mutually exclusive: omit one of them");
    }

    /** This signature with another mean cross-section, m2. */
    public RadarSignature withCrossSection(double area) {
        return SettingsForm.with(this, "crossSection", area);
    }

    /** This signature with another fluctuation. */
    public RadarSignature withFluctuation(Fluctuation other) {
        return SettingsForm.with(this, "fluctuation", other);
    }

    /** This signature with other aspect-dependent cross-sections relative to the mean, dB. */
    public RadarSignature withAspects(List<Double> gains) {
        return SettingsForm.with(this, "aspects", gains);
    }

    /** This signature with a log-normal distribution of this standard deviation, dB. */
    public RadarSignature withSpread(double decibels) {
        return SettingsForm.with(this, "spread", Optional.of(decibels));
    }

    /** This signature with an echo of the rotors, dB below that of the body. */
    public RadarSignature withRotorLevel(double decibels) {
        return SettingsForm.with(this, "rotorLevel", Optional.of(decibels));
    }

    /** The fraction of the cross-section that is due to the drone's rotors while they turn, 0 to 0.5. */
    public double rotorFraction() {
        return rotorLevel
                .map(level -> 1.0 / (1.0 + Math.pow(10.0, 0.1 * level)))
                .orElse(0.0);
    }

    /** The signature of a class of drones, the same for all aspects. */
    public static RadarSignature of(DroneClass drones) {
        return SettingsForm.with(DEFAULT, "droneClass", Optional.of(drones));
    }

    /** The mean cross-section, m2: that of the signature itself, or that of its class. */
    public double mean() {
        return droneClass.map(DroneClass::crossSection).orElse(crossSection);
    }

    /** The standard deviation in dB of a log-normal distribution, stated or that of the class; 0 without one. */
    public double deviation() {
        return droneClass.map(DroneClass::spread).or(() -> spread).orElse(0.0);
    }

    /**
     * The cross-section at one aspect, m2: interpolated linearly in decibels between two aspects.
     *
     * @param aspect bearing of the radar, clockwise from the drone's nose as seen from above, rad
     */
    public double towards(double aspect) {
        double turns = aspect / (2.0 * Math.PI);
        double index = (turns - Math.floor(turns)) * aspects.size();
        int before = (int) index % aspects.size();
        int after = (before + 1) % aspects.size();
        double share = index - Math.floor(index);
        double gain = (1.0 - share) * aspects.get(before) + share * aspects.get(after);
        return mean() * Math.pow(10.0, 0.1 * gain);
    }
}
