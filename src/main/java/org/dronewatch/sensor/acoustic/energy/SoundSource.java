package org.dronewatch.sensor.acoustic.energy;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.tone.LineSpectrum;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;

/** The sound source of a drone: its position, sound power levels and directivity. */
public final class SoundSource {
    /** The radius of a small drone, m. */
    private static final double SIZE = 0.1;

    private final Position position;
    private final double[] power;
    private final EmissionPattern pattern;
    private final double emitted;
    private final LineSpectrum lines;

    /**
     * A source.
     *
     * @param position position of the source, m
     * @param powerLevels sound power level in each band, dB re 1 pW; minus infinity for silence
     * @param directivity dependence of the level on the elevation at which the sound leaves the source
     */
    public SoundSource(Position position, List<Double> powerLevels, Directivity directivity) {
        this.position = position;
        this.power = powerLevels.stream().mapToDouble(Levels::toRatio).toArray();
        this.pattern = EmissionPattern.of(directivity);
        double sum = 0.0;
        for (double inBand : power) {
            sum += inBand;
        }
        this.emitted = sum;
        this.lines = LineSpectrum.NONE;
    }

    private SoundSource(Position position, LineSpectrum lines, SoundSource like) {
        this.position = position;
        this.power = like.power;
        this.pattern = like.pattern;
        this.emitted = like.emitted;
        this.lines = lines;
    }

    /** This source with tones in its spectrum, which are part of its power. */
    public SoundSource with(LineSpectrum spectrum) {
        return new SoundSource(position, spectrum, this);
    }

    /** This source at another position. */
    SoundSource at(Position other) {
        return other.equals(position) ? this : new SoundSource(other, lines, this);
    }

    /** The position of the source. */
    Position position() {
        return position;
    }

    /** The lines in its spectrum. */
    LineSpectrum lines() {
        return lines;
    }

    /** Power of all bands together, relative to 1 pW. */
    double emitted() {
        return emitted;
    }

    /** Power in a band as a fraction of that of all bands; 0 for silence. */
    double fraction(int band) {
        return emitted > 0.0 ? power[band] / emitted : 0.0;
    }

    /**
     * Directivity factor of a band in one direction: its mean over all directions is 1.
     *
     * @param rise sine of the elevation at which the sound leaves
     */
    double factor(int band, double rise) {
        return pattern.factor(band, rise);
    }

    /**
     * Intensity in a band divided by the source's power, 1/m2: spread over the sphere and attenuated by the air. At
     * distances below {@value #SIZE} m, it no longer increases, since a drone is not a point.
     *
     * @param rise sine of the elevation at which the sound leaves
     * @param length length of the path, m
     */
    double spread(Air air, int band, double rise, double length) {
        double radius = Math.max(SIZE, length);
        return fraction(band) * factor(band, rise) * air.left(band, length) / (4.0 * Math.PI * radius * radius);
    }
}
