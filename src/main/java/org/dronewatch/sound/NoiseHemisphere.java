package org.dronewatch.sound;

import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The sound that a drone radiated in flight over a line of microphones: octave-band levels at a distance of 1 m below
 * it, by angle from the vertical. They are computed from a table of third-octave bands by angle along the track and
 * across it. A source has no heading here, so the level at each angle from the vertical is the energy mean over all
 * headings that were measured at this angle.
 */
final class NoiseHemisphere {
    /**
     * Angles beyond this were not measured: for them, the table contains the levels at this angle, reduced by 3.5 dB
     * for each step.
     */
    static final double MEASURED = Math.toRadians(60.0);

    /** Step from one angle to the next: the angular spacing of the microphones across the track. */
    private static final double STEP = Math.toRadians(15.0);

    private static final int ANGLES = 7;
    private static final int BANDS = OctaveBands.COUNT;
    private static final int HEADINGS = 360;
    private static final double ROUNDING = 1e-9;

    /**
     * Nominal frequencies of the lowest third-octave band of each octave, and of the first band above the highest
     * octave, Hz.
     */
    private static final int[] LOWEST_THIRD = {50, 100, 200, 400, 800, 1600, 3150, 6300, 12_500};

    private final List<Double> along = new ArrayList<>();
    private final List<Double> across = new ArrayList<>();

    /** Energies by band, angle along the track and angle across it. */
    private final List<List<double[]>> octaves = new ArrayList<>();

    private final double[][] levels = new double[BANDS][ANGLES];

    /** Reads a table from the resources beside this class. */
    NoiseHemisphere(String resource) {
        read(resource);
        for (int band = 0; band < BANDS; band++) {
            for (int i = 0; i < ANGLES; i++) {
                double energy = i * STEP > MEASURED + ROUNDING ? filledIn(band, i * STEP) : measured(band, i * STEP);
                levels[band][i] = Levels.ofRatio(energy);
            }
        }
    }

    /**
     * Sound pressure level at 1 m, dB re 20 uPa, interpolated linearly between angles.
     *
     * @param band 0 for 63 Hz to 7 for 8 kHz
     * @param fromVertical angle between the direction and straight down, 0 to pi/2 rad
     */
    double level(int band, double fromVertical) {
        double at = Math.min(fromVertical / STEP, ANGLES - 1.0);
        int i = Math.min((int) at, ANGLES - 2);
        return levels[band][i] + (at - i) * (levels[band][i + 1] - levels[band][i]);
    }

    /** Energy mean over all headings at which both angles of a direction were measured. */
    private double measured(int band, double fromVertical) {
        double sum = 0.0;
        int count = 0;
        for (int i = 0; i < HEADINGS; i++) {
            double heading = 2.0 * Math.PI * (i + 0.5) / HEADINGS;
            double onTrack = Math.atan(Math.tan(fromVertical) * Math.cos(heading));
            double beside = Math.atan(Math.tan(fromVertical) * Math.sin(heading));
            if (Math.abs(onTrack) <= along.get(along.size() - 1) && Math.abs(beside) <= MEASURED) {
                sum += energy(band, onTrack, beside);
                count++;
            }
        }
        return sum / count;
    }

    /** The mean over both sides of the track. */
    private double filledIn(int band, double fromVertical) {
        return 0.5 * (energy(band, 0.0, fromVertical) + energy(band, 0.0, -fromVertical));
    }

    private double energy(int band, double onTrack, double beside) {
        int i = below(along, onTrack);
        int j = below(across, beside);
        double u = (onTrack - along.get(i)) / (along.get(i + 1) - along.get(i));
        double v = (beside - across.get(j)) / (across.get(j + 1) - across.get(j));
        double near = (1.0 - v) * level(band, i, j) + v * level(band, i, j + 1);
        double far = (1.0 - v) * level(band, i + 1, j) + v * level(band, i + 1, j + 1);
        return Levels.toRatio((1.0 - u) * near + u * far);
    }

    private double level(int band, int i, int j) {
        return Levels.ofRatio(octaves.get(band).get(i)[j]);
    }

    /** Index of the last of the angles, except the very last, that is not above a given angle; 0 if there is none. */
    private static int below(List<Double> angles, double angle) {
        int i = 0;
        while (i < angles.size() - 2 && angles.get(i + 1) <= angle) {
            i++;
        }
        return i;
    }

    private void read(String resource) {
        try (InputStream stream = Objects.requireNonNull(NoiseHemisphere.class.getResourceAsStream(resource));
                Reader text = new InputStreamReader(stream, StandardCharsets.UTF_8);
                CsvReader<NamedCsvRecord> records = CsvReader.builder().ofNamedCsvRecord(text)) {
            for (NamedCsvRecord row : records) {
                add(row);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void add(NamedCsvRecord row) {
        if (across.isEmpty()) {
            row.getHeader().stream()
                    .filter(name -> name.startsWith("lateral_"))
                    .map(name -> Double.parseDouble(name.replace("lateral_", "").replace("_deg", "")))
                    .forEach(degrees -> across.add(Math.toRadians(degrees)));
            for (int band = 0; band < BANDS; band++) {
                octaves.add(new ArrayList<>());
            }
        }
        double onTrack = Math.toRadians(Double.parseDouble(row.getField("along_track_deg")));
        if (along.isEmpty() || onTrack > along.get(along.size() - 1)) {
            along.add(onTrack);
            octaves.forEach(angles -> angles.add(new double[across.size()]));
        }
        int frequency = Integer.parseInt(row.getField("band_hz"));
        for (int band = 0; band < BANDS; band++) {
            if (frequency >= LOWEST_THIRD[band] && frequency < LOWEST_THIRD[band + 1]) {
                double[] energies = octaves.get(band).get(along.indexOf(onTrack));
                for (int j = 0; j < energies.length; j++) {
                    energies[j] += Levels.toRatio(Double.parseDouble(row.getField(j + 2)));
                }
            }
        }
    }
}
