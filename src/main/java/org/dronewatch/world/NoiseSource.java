package org.dronewatch.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.BandLevels;

/**
 * A source of steady noise on the site, such as a factory or a road. Its sound travels to microphones as that of drones
 * does, in addition to the background noise.
 *
 * @param positions positions of the source, m: a single one for a factory, or the points of a line, such as a road,
 *     whose power is uniform along its length
 * @param soundPowerLevel A-weighted sound power level of the whole source for the energy model, -20 to 200 dB re 1 pW
 * @param shape spectrum of the sound power: the levels of the octave bands relative to one another, without weighting,
 *     dB
 * @param soundLevel initial level of its rays on the calibrated scale of the level model, -100 to 200 dB; if omitted,
 *     microphones with that model do not hear the source
 */
public record NoiseSource(
        List<Position> positions,
        @In(value = Quantity.LEVEL, from = -20, to = 200) double soundPowerLevel,
        BandLevels shape,
        @In(value = Quantity.LEVEL, from = -100, to = 200) Optional<Double> soundLevel) {
    /** A line is divided until no piece is longer than this fraction of its distance: 0.03 dB. */
    private static final double LONGEST = 0.25;

    /** The shortest piece, m, for listeners that are on the line. */
    private static final double SHORTEST = 0.1;

    /**
     * Checks the limits and copies the list.
     *
     * @throws IllegalArgumentException if a value is out of range, there is no position, or a line has no length
     */
    public NoiseSource {
        Limits.check(NoiseSource.class, positions, soundPowerLevel, shape, soundLevel);
        positions = List.copyOf(positions);
        if (positions.isEmpty()) {
            throw new IllegalArgumentException("positions is empty: a noise source needs at least one");
        }
        if (positions.size() > 1 && !(length(positions) > 0.0)) {
            throw new IllegalArgumentException("positions are all the same: a line needs a length");
        }
    }

    /**
     * A source with the default spectrum, at one position or along a line, with its A-weighted sound power level, dB re
     * 1 pW.
     */
    @Defaults({"positions", "soundPowerLevel"})
    public static NoiseSource along(List<Position> positions, double soundPowerLevel) {
        return new NoiseSource(positions, soundPowerLevel, BackgroundNoise.FALLING, Optional.empty());
    }

    /** A source at one position, with the default spectrum and its A-weighted sound power level, dB re 1 pW. */
    public static NoiseSource at(Position position, double soundPowerLevel) {
        return along(List.of(position), soundPowerLevel);
    }

    /** This source with another spectrum: levels of the bands relative to one another, dB. */
    public NoiseSource withShape(BandLevels other) {
        return SettingsForm.with(this, "shape", other);
    }

    /** This source with a level for the level model, dB. */
    public NoiseSource withSoundLevel(double level) {
        return SettingsForm.with(this, "soundLevel", Optional.of(level));
    }

    /** Sound power levels of the whole source by octave band, without weighting, dB re 1 pW. */
    public BandLevels power() {
        return shape.plus(soundPowerLevel - shape.aWeighted());
    }

    /**
     * A piece of a source, short enough to be a point source for a listener.
     *
     * @param position position of its middle, m
     * @param fraction its fraction of the source's power, 0 to 1
     */
    public record Piece(Position position, double fraction) {}

    /** The pieces of the source for a listener at a position, m, in the order of the source's positions. */
    public List<Piece> pieces(Position listener) {
        if (positions.size() == 1) {
            return List.of(new Piece(positions.get(0), 1.0));
        }
        double whole = length(positions);
        List<Piece> pieces = new ArrayList<>();
        for (int i = 1; i < positions.size(); i++) {
            divide(positions.get(i - 1), positions.get(i), listener, whole, pieces);
        }
        return pieces;
    }

    private static void divide(Position from, Position to, Position listener, double whole, List<Piece> pieces) {
        double length = from.distance(to);
        Position middle = from.plus(to).times(0.5);
        double nearest = Math.max(0.0, middle.distance(listener) - 0.5 * length);
        if (length > Math.max(SHORTEST, LONGEST * nearest)) {
            divide(from, middle, listener, whole, pieces);
            divide(middle, to, listener, whole, pieces);
        } else if (length > 0.0) {
            pieces.add(new Piece(middle, length / whole));
        }
    }

    private static double length(List<Position> positions) {
        double length = 0.0;
        for (int i = 1; i < positions.size(); i++) {
            length += positions.get(i - 1).distance(positions.get(i));
        }
        return length;
    }
}
