package org.dronewatch.sensor.acoustic.tone;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.NarrowBand;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.Tone;

/**
 * The tones in a drone's sound, at their frequencies at the microphone. A tone is taken to be attenuated as much as its
 * octave band is on average, and the spectra of noise and of broadband sound to be flat within each octave band.
 * Immutable.
 */
public final class LineSpectrum {
    /** The spectrum of a drone without tones. */
    public static final LineSpectrum NONE =
            new LineSpectrum(List.of(), Collections.nCopies(OctaveBands.COUNT, 0.0), 0.0, 1.0, 0.0);

    private final List<Line> lines = new ArrayList<>();

    /** The fraction of each octave band's power that is not in lines. */
    private final double[] broadband = new double[OctaveBands.COUNT];

    /** A line, with its power as a fraction of that of the octave band in which it travels. */
    private record Line(int harmonic, NarrowBand band, int travelling, double ratio) {}

    /**
     * The tones of a drone in flight. Tones that lie outside the octave bands at the microphone are left out.
     *
     * @param tones the tones, with their emitted frequencies
     * @param powerLevels sound power levels of the octave bands, tones included, dB re 1 pW
     * @param approach speed of the drone towards the microphone, m/s; negative when it flies away
     * @param soundSpeed speed of sound in the air, m/s
     * @param wind wind speed, which widens the tones, m/s, 0 or more
     */
    public LineSpectrum(List<Tone> tones, List<Double> powerLevels, double approach, double soundSpeed, double wind) {
        Arrays.fill(broadband, 1.0);
        for (Tone tone : tones) {
            Optional<NarrowBand> emitted = NarrowBand.ofLine(tone.frequency(), wind);
            if (emitted.isEmpty()) {
                continue;
            }
            int own = emitted.get().octave();
            broadband[own] = Math.max(0.0, broadband[own] - tone.share());
            tone.heard(approach, soundSpeed)
                    .ifPresent(frequency -> NarrowBand.ofLine(frequency, wind).ifPresent(heard -> {
                        // In the air, the tone has the frequency at which it is heard. A silent band reveals nothing
                        // about the path.
                        boolean known = Double.isFinite(powerLevels.get(heard.octave()));
                        int travelling = known ? heard.octave() : own;
                        double power = Levels.toRatio(powerLevels.get(own) - powerLevels.get(travelling));
                        lines.add(new Line(tone.harmonic(), heard, travelling, tone.share() * power));
                    }));
        }
    }

    /**
     * The tones at the microphone, the lowest harmonic first.
     *
     * @param energies mean-square sound pressure in each octave band, relative to (20 uPa)^2
     * @param noise sound pressure levels of the noise in the octave bands, dB re 20 uPa
     */
    public List<HeardTone> heard(IntToDoubleFunction energies, BandLevels noise) {
        List<HeardTone> heard = new ArrayList<>(lines.size());
        for (Line line : lines) {
            NarrowBand band = line.band();
            double energy = energies.applyAsDouble(line.travelling()) * line.ratio()
                    + energies.applyAsDouble(band.octave()) * broadband[band.octave()] * band.fraction();
            double snr = Levels.ofRatio(energy) - noise.level(band.octave()) + band.gain();
            heard.add(new HeardTone(line.harmonic(), band, snr));
        }
        return heard;
    }

    /**
     * The tone that is highest above the noise; if several are equally high, the lowest in frequency.
     *
     * @param energies mean-square sound pressure in each octave band, relative to (20 uPa)^2
     * @param noise sound pressure levels of the noise in the octave bands, dB re 20 uPa
     * @return empty when there are no tones
     */
    public Optional<HeardTone> best(IntToDoubleFunction energies, BandLevels noise) {
        return heard(energies, noise).stream()
                .sorted(Comparator.comparingDouble(HeardTone::snr).reversed())
                .findFirst();
    }
}
