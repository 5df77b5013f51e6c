package org.dronewatch.terrain.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tiles of SRTM: 1201 or 3601 posts a side, high byte first. */
class HgtFileTest {
    @TempDir
    private Path directory;

    /** Every post has its row plus its column as its height, except one void. */
    private static byte[] tile(int side) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * side * side);
        for (int i = 0; i < side * side; i++) {
            bytes.putShort((short) (i == 2 * side + 3 ? -32768 : i / side + i % side - 500));
        }
        return bytes.array();
    }

    private static byte[] zipped(String... entries) throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(all)) {
            zip.setLevel(1);
            for (String entry : entries) {
                zip.putNextEntry(new ZipEntry(entry));
                zip.write(entry.endsWith(".hgt") ? tile(1201) : new byte[] {1, 2, 3});
            }
        }
        return all.toByteArray();
    }

    private ElevationFile open(String name, byte[] bytes) throws IOException {
        Files.write(directory.resolve(name), bytes);
        return new ElevationFiles(directory).open(name);
    }

    private static void check(ElevationFile file, int side) throws IOException {
        assertThat(file.columns()).isEqualTo(side);
        float[] heights = file.heights(new Window(1, 1, 4, 3));
        assertThat(heights)
                .containsExactly(-498, -497, -496, -495, -497, -496, Float.NaN, -494, -496, -495, -494, -493);
    }

    @ParameterizedTest
    @CsvSource({"1201, N43E007.hgt, 7, 44", "3601, S34W071.hgt, -71, -33", "1201, n00e000_srtm.hgt, 0, 1"})
    void theNameSaysWhereTheTileIs(int side, String name, double west, double north) throws IOException {
        ElevationFile file = open(name, tile(side));
        check(file, side);
        assertThat(file.lattice().xAt(0, 0)).isEqualTo(west);
        assertThat(file.lattice().yAt(0, 0)).isEqualTo(north);
        assertThat(file.lattice().xAt(side - 1, side - 1)).isEqualTo(west + 1, within(1e-12));
        assertThat(file.lattice().yAt(side - 1, side - 1)).isEqualTo(north - 1, within(1e-12));
        assertThat(file.crs()).hasToString("Optional[EPSG:4326]");
    }

    @Test
    void tilesMayBePacked() throws IOException {
        check(open("tile.zip", zipped("readme.txt", "N43E007/N43E007.hgt")), 1201);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (OutputStream gzip = new GZIPOutputStream(packed)) {
            gzip.write(tile(1201));
        }
        check(open("N43E007.hgt.gz", packed.toByteArray()), 1201);
    }

    private void refused(String name, byte[] bytes, String part) {
        assertThatThrownBy(() -> open(name, bytes))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(name)
                .hasMessageContaining(part)
                .hasMessageNotContaining("\n");
    }

    @Test
    void whatIsNoTileIsRefused() throws IOException {
        refused("N43E007.hgt", new byte[2 * 1200 * 1200], "has 2880000 bytes");
        refused("monaco.hgt", tile(1201), "the name must begin with");
        refused("N95E007.hgt", tile(1201), "no tile on earth has this name");
        refused("none.zip", zipped("readme.txt"), "has no .hgt file");
        refused("two.zip", zipped("N43E007.hgt", "N43E008.hgt"), "several .hgt files");
        byte[] whole = zipped("N43E007.hgt");
        refused("cut.zip", java.util.Arrays.copyOf(whole, whole.length / 2), "truncated or damaged");
        refused("N43E007.hgt.gz", new byte[] {0x1F, (byte) 0x8B, 8, 0, 0, 0, 0, 0, 0, 0, 1, 2}, "truncated or damaged");
    }

    /** 200 MB in a few hundred kilobytes: no more is unpacked than the largest tile has. */
    @Test
    void bombsAreNotUnpacked() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (OutputStream gzip = new GZIPOutputStream(packed)) {
            byte[] some = new byte[1 << 20];
            for (int i = 0; i < 100; i++) {
                gzip.write(some);
            }
        }
        refused("N43E007.hgt.gz", packed.toByteArray(), "unpacks to more than");
        refused("tile.zip", zipBomb("N43E007.hgt"), "unpacks to more than the 25934402 bytes of the largest tile");
        refused("tile.zip", zipBomb("readme.txt"), "'readme.txt' unpacks to more than 25934402 bytes: leave it out");
    }

    private static byte[] zipBomb(String entry) throws IOException {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(all)) {
            zip.putNextEntry(new ZipEntry(entry));
            byte[] some = new byte[1 << 20];
            for (int i = 0; i < 100; i++) {
                zip.write(some);
            }
        }
        return all.toByteArray();
    }
}
