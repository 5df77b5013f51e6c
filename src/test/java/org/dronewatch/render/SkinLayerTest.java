package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.render.canvas.Cut;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A skin lies where it should: on the ground and on top of the wall, not on its sides nor in the sky. */
class SkinLayerTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final int GROUND = 0x0000ff;
    private static final int TOP = 0xff0000;

    /** From the south and above. */
    private static final Orbit SOUTH = new Orbit(new Position(0, 0, 4), Math.PI, 0.4, 70, 0.6);

    private static final SiteStyle BARE = new SiteStyle(1.0, false, false, false, RayFilter.ALL);

    /** The wall stands on 20 m by 1 m; the skin is red above it, and blue elsewhere. */
    private static final SiteSkin SKIN = (east, north, column, row, below) -> isWall(east, north) ? TOP : GROUND;

    @TempDir
    private Path directory;

    private SitePicture pictures;

    @BeforeEach
    void buildYard() {
        Yard yard = new Yard(directory);
        pictures = new SitePicture(yard.settings(), yard.stage());
    }

    private static boolean isWall(double east, double north) {
        return Math.abs(east) < 10.0 && north > 0.0 && north < 1.0;
    }

    private Backdrop backdrop(Fineness fineness, Optional<Cut> cut) {
        return pictures.backdrop(SOUTH, WIDTH, HEIGHT, cut, fineness, () -> false);
    }

    private BufferedImage drawn(Backdrop backdrop, Optional<SiteSkin> skin) {
        SiteState state = new SiteState("yard", 0.0, List.of(), List.of(), Optional.empty(), Optional.empty());
        return pictures.draw(backdrop, state, BARE.withSkin(skin));
    }

    @ParameterizedTest
    @EnumSource(
            value = Fineness.class,
            names = {"PLAIN", "DRAFT"})
    void groundAndRoofAreColouredByTheirPlace(Fineness fineness) {
        Backdrop backdrop = backdrop(fineness, Optional.empty());
        Backdrop skinned = new SkinLayer(new Facets(new Yard(directory).stage().world(), java.util.Map.of()))
                .over(backdrop, SKIN, 1.0);
        int[] counts = new int[4];
        int columns = backdrop.canvas().width;
        for (int pixel = 0; pixel < backdrop.canvas().rgb.length; pixel++) {
            int column = pixel % columns;
            int row = pixel / columns;
            Optional<Position> place = backdrop.placeAt(column * fineness.pixels, row * fineness.pixels);
            int colour = skinned.canvas().rgb[pixel];
            if (place.isEmpty() || place.get().z() > 0.01 && place.get().z() < 7.99) {
                assertThat(colour).as("sky or wall").isEqualTo(backdrop.canvas().rgb[pixel]);
                counts[place.isEmpty() ? 0 : 1]++;
            } else if (place.get().z() >= 7.99) {
                counts[2] += colour == TOP ? 1 : 0;
            } else {
                assertThat(colour).as("ground at %s", place.get()).isEqualTo(GROUND);
                counts[3]++;
            }
        }
        int all = backdrop.canvas().rgb.length;
        assertThat(counts[0]).as("sky").isGreaterThan(all / 100);
        assertThat(counts[1]).as("wall").isGreaterThan(all / 50);
        assertThat(counts[2]).as("top of the wall").isGreaterThan(all / 1000);
        assertThat(counts[3]).as("ground").isGreaterThan(all / 4);
    }

    @Test
    void theBackdropStaysAsItIsAndWithoutASkinNothingIsLaid() {
        Backdrop backdrop = backdrop(Fineness.PLAIN, Optional.empty());
        int[] before = backdrop.canvas().rgb.clone();
        BufferedImage with = drawn(backdrop, Optional.of(SKIN));
        assertThat(backdrop.canvas().rgb).isEqualTo(before);
        BufferedImage without = drawn(backdrop, Optional.empty());
        int[] painted = without.getRGB(0, 0, WIDTH, HEIGHT / 4 * 3, null, 0, WIDTH);
        assertThat(with.getRGB(0, 0, WIDTH, HEIGHT / 4 * 3, null, 0, WIDTH)).isNotEqualTo(painted);
    }

    /** Where the wall is cut open, the section is neither ground nor roof. */
    @Test
    void whatIsCutOpenHasNoSkin() {
        Backdrop backdrop = backdrop(Fineness.PLAIN, Optional.of(Cut.above(5.0)));
        Backdrop skinned = new SkinLayer(new Facets(new Yard(directory).stage().world(), java.util.Map.of()))
                .over(backdrop, SKIN, 1.0);
        assertThat(skinned.canvas().rgb).contains(GROUND).doesNotContain(TOP);
    }

    /** Patterns keep their size on screens of any density, and in pictures with several rays for each pixel. */
    @Test
    void patternsAreInPixelsOfAPictureOfNormalDensity() {
        SiteSkin columns = (east, north, column, row, below) -> column;
        SkinLayer layer = new SkinLayer(new Facets(new Yard(directory).stage().world(), java.util.Map.of()));
        for (Fineness fineness : List.of(Fineness.PLAIN, Fineness.FINE)) {
            Backdrop backdrop = backdrop(fineness, Optional.empty());
            for (double scale : new double[] {1.0, 2.0}) {
                Canvas canvas = layer.over(backdrop, columns, scale).canvas();
                int pixel = canvas.width * (canvas.height - 1) + canvas.width - 1;
                assertThat(canvas.rgb[pixel]).isEqualTo((int) ((canvas.width - 1.0) * WIDTH / canvas.width / scale));
            }
        }
    }
}
