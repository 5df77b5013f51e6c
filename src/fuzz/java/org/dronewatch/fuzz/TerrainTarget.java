package org.dronewatch.fuzz;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.dronewatch.terrain.io.TiffFixture;

/** Files of elevations: GeoTIFF in many ways, ASCII grids and compressed tiles, damaged and with sizes that lie. */
final class TerrainTarget implements FuzzTarget {
    private static final List<Integer> TAGS = List.of(
            256, 257, 258, 259, 262, 273, 277, 278, 279, 317, 322, 323, 324, 325, 339, 33550, 33922, 34735, 42112,
            42113);

    private static final List<Long> LIES =
            List.of(0L, 1L, 2L, 3L, 7L, 16L, 255L, 1000L, 65_535L, 1_000_000L, 0x7FFFFFFFL, 0x80000000L, 0xFFFFFFFFL);

    @Override
    public String name() {
        return "terrain";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        return switch ((int) (number % 4)) {
            case 0 ->
                scene("damaged GeoTIFF", "dem.tif", ByteMutation.of(tiff(dice).bytes(), dice));
            case 1 -> scene("GeoTIFF that lies", "dem.tif", lying(dice));
            case 2 -> scene("damaged ASCII grid", "dem.asc", ByteMutation.of(grid(dice), dice));
            default -> scene("damaged packed tile", "N50E014.hgt.gz", ByteMutation.of(tile(dice), dice));
        };
    }

    private static FuzzCase scene(String what, String file, byte[] content) {
        String crs = file.endsWith(".asc") ? ", crs: EPSG:32633" : "";
        String scene = "world:\n  origin: {latitude: 50.08 deg, longitude: 14.42 deg}\n  terrain: {file: " + file + crs
                + "}\n";
        return FuzzCase.of(what, "scene.yaml", scene, "check", "{}/scene.yaml").with(file, content);
    }

    private static TiffFixture tiff(Dice dice) {
        int columns = dice.between(2, 60);
        int rows = dice.between(2, 60);
        double[] samples = new double[columns * rows];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = dice.oneIn(50) ? dice.pick(0.0, -9999.0, -32768.0, 3e38, Double.NaN) : dice.below(200);
        }
        TiffFixture file = new TiffFixture(columns, rows, samples);
        file.tie = new double[] {0, 0, 0, 458_300, 5_547_900, 0};
        file.order = dice.oneIn(2) ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
        file.big = dice.oneIn(4);
        file.compression = dice.pick(1, 5, 8, 32773);
        file.tile = dice.oneIn(2) ? 16 : 0;
        file.predictor = file.compression == 5 || file.compression == 8 ? dice.between(1, 3) : 1;
        file.missingBlock = dice.oneIn(4) ? 0 : -1;
        file.nodata = dice.pick("", "-9999", "nan", "0");
        return file;
    }

    private static byte[] lying(Dice dice) {
        TiffFixture file = tiff(dice);
        for (int i = dice.between(1, 3); i > 0; i--) {
            file.lies.put(TAGS.get(dice.below(TAGS.size())), LIES.get(dice.below(LIES.size())));
        }
        return file.bytes();
    }

    private static byte[] grid(Dice dice) {
        int side = dice.between(2, 40);
        StringBuilder text = new StringBuilder("ncols " + side + "\nnrows " + side
                + "\nxllcorner 458300\nyllcorner 5547500\ncellsize 10\nNODATA_value -1\n");
        for (int i = 0; i < side * side; i++) {
            text.append(dice.below(200)).append(i % side == side - 1 ? '\n' : ' ');
        }
        return text.toString().getBytes(StandardCharsets.US_ASCII);
    }

    private static byte[] tile(Dice dice) {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (OutputStream gzip = new GZIPOutputStream(packed)) {
            byte[] row = new byte[2 * 1201];
            for (int i = 0; i < 1201; i++) {
                row[dice.below(row.length)] ^= 1;
                gzip.write(row);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return packed.toByteArray();
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        Judge.check(CommandRun.of(input.argumentsIn(directory)), directory);
    }
}
