package org.dronewatch.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.junit.jupiter.api.Test;

class CathedralModelTest {
    private static final KDTree TREE = KDTree.of(new ModelLoader(Path.of("models"))
            .load(ModelSettings.of("cathedral.obj"))
            .mesh());
    private static final Mesh MODEL = CathedralModel.mesh();

    @Test
    void itHasTheSizeOfARealModel() {
        assertThat(TREE.mesh().triangleCount()).isBetween(120_000, 140_000);
    }

    /** From places in nave, aisles, clerestory and apse, in all directions. */
    @Test
    void noRayGetsOut() {
        long seed = 1163;
        SplittableRandom random = new SplittableRandom(seed);
        RayTracer traversal = new StackTraversal(TREE);
        for (int i = 0; i < 200_000; i++) {
            double x = -29 + 64 * random.nextDouble();
            double z = 0.2 + 13.5 * random.nextDouble();
            double y = halfWidth(x, z) * (2 * random.nextDouble() - 1);
            double up = 2 * random.nextDouble() - 1;
            double angle = 2 * Math.PI * random.nextDouble();
            double level = Math.sqrt(1 - up * up);
            boolean hit = traversal.closestHit(
                    x, y, z, level * Math.cos(angle), level * Math.sin(angle), up, 0, Double.POSITIVE_INFINITY);
            assertThat(hit).as("ray %d of seed %d", i, seed).isTrue();
            assertThat(traversal.distance()).isLessThan(75.0);
        }
    }

    /** How far the room certainly reaches to each side of its middle: the apse, the aisles, or the nave above them. */
    private static double halfWidth(double x, double z) {
        double beyond = x - CathedralModel.HALF_LENGTH_METRES;
        if (beyond > 0) {
            return 0.95 * Math.sqrt(Math.pow(CathedralModel.NAVE_HALF_WIDTH_METRES, 2) - beyond * beyond);
        }
        return z < 5.9 ? CathedralModel.HALF_WIDTH_METRES - 0.2 : CathedralModel.NAVE_HALF_WIDTH_METRES - 0.2;
    }

    @Test
    void aDroneHasRoomAlongTheNave() {
        RayTracer traversal = new StackTraversal(TREE);
        for (double x = -20; x <= 30; x += 5) {
            for (int way = 0; way < 64; way++) {
                double angle = 2 * Math.PI * way / 64;
                assertThat(traversal.isOccluded(x, 0, 5, Math.cos(angle), Math.sin(angle), 0, 0, 4.5))
                        .as("from x = %f", x)
                        .isFalse();
            }
        }
    }

    /** Evenly spread directions from the free place. */
    @Test
    void theFreePlaceIsFree() {
        Point place = CathedralModel.FREE_PLACE;
        RayTracer traversal = new StackTraversal(TREE);
        int directions = 5000;
        for (int i = 0; i < directions; i++) {
            double up = 1 - (2 * i + 1.0) / directions;
            double level = Math.sqrt(1 - up * up);
            double angle = i * Math.PI * (3 - Math.sqrt(5));
            double east = level * Math.cos(angle);
            double north = level * Math.sin(angle);
            assertThat(traversal.isOccluded(
                            place.x(), -place.z(), place.y(), east, north, up, 0, CathedralModel.FREE_RADIUS_METRES))
                    .as("direction %d", i)
                    .isFalse();
        }
    }

    /** The skin is the first part; its corners reach exactly where the constants say. */
    @Test
    void theRoomHasItsStatedSize() {
        List<Point> corners = corners(shell());
        Extent room = Extent.of(corners);
        double end = CathedralModel.HALF_LENGTH_METRES;

        assertThat(room.min()).isEqualTo(new Point(-end, 0, -CathedralModel.HALF_WIDTH_METRES));
        assertThat(room.max())
                .isEqualTo(new Point(
                        end + CathedralModel.NAVE_HALF_WIDTH_METRES,
                        CathedralModel.CROWN_METRES,
                        CathedralModel.HALF_WIDTH_METRES));
        assertThat(corners.stream().filter(p -> Math.abs(p.z()) > CathedralModel.NAVE_HALF_WIDTH_METRES))
                .allMatch(p -> p.y() <= CathedralModel.AISLE_CROWN_METRES);
    }

    @Test
    void theReadmeTellsItsVolumeAndParts() throws IOException {
        double volume = 0;
        for (Mesh.Face face : shell().faces()) {
            Point a = corner(face, 0);
            for (int i = 1; i <= face.triangles(); i++) {
                volume -= a.dot(corner(face, i).cross(corner(face, i + 1))) / 6;
            }
        }
        String readme = Files.readString(Path.of("models", "README.md"));
        assertThat(readme).contains(String.format(Locale.ROOT, "%,d m³", 100 * Math.round(volume / 100)));
        assertThat(readme)
                .contains("faces inwards, and " + (MODEL.parts().size() - 1) + " closed parts |")
                .contains("within %.0f m of the point %.0f m above the origin"
                        .formatted(CathedralModel.FREE_RADIUS_METRES, CathedralModel.FREE_PLACE.y()));
    }

    @Test
    void itsMaterialsAreInTheTableOfSurfaces() {
        assertThat(MODEL.materials()).extracting(Material::name).isSubsetOf(SurfaceMaterials.names());
    }

    private Mesh.Part shell() {
        Mesh.Part first = MODEL.parts().get(0);
        assertThat(first.name()).isEqualTo("shell");
        return first;
    }

    private List<Point> corners(Mesh.Part part) {
        return part.faces().stream()
                .flatMap(face -> face.corners().stream())
                .map(MODEL.vertices()::get)
                .toList();
    }

    private Point corner(Mesh.Face face, int index) {
        return MODEL.vertices().get(face.corners().get(index));
    }

    @Test
    void theVaultIsPointed() {
        assertThat(CathedralModel.pointed(0)).isCloseTo(1.0, within(1e-12));
        assertThat(CathedralModel.pointed(1)).isCloseTo(0.0, within(1e-7));
        // A round arch would be level at its crown.
        assertThat((CathedralModel.pointed(0) - CathedralModel.pointed(0.01)) / 0.01)
                .isGreaterThan(0.2);
    }
}
