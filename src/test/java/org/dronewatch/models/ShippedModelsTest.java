package org.dronewatch.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ShippedModelsTest {
    private static final Path SHIPPED = Path.of("models");

    @Thorough
    @ParameterizedTest
    @EnumSource
    void theFilesAreWhatTheCodeMakes(ModelCatalogue model) throws IOException {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG"));
            for (Map.Entry<String, byte[]> file :
                    ModelCatalogue.files(model.mesh()).entrySet()) {
                assertThat(Files.readAllBytes(SHIPPED.resolve(file.getKey())))
                        .as(file.getKey())
                        .isEqualTo(file.getValue());
            }
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void theyAreSmall() throws IOException {
        long total = 0;
        try (var files = Files.list(SHIPPED)) {
            for (Path file : files.toList()) {
                total += Files.size(file);
            }
        }
        assertThat(total).isLessThan(20_000_000);
    }

    /** Every edge of a part belongs to two faces that run along it in opposite directions; solids face outward. */
    @ParameterizedTest
    @EnumSource(names = {"QUADROTOR", "FIXED_WING", "HYBRID_GLIDER", "HOUSE", "CATHEDRAL"})
    void everyPartIsAClosedSolidThatFacesOutward(ModelCatalogue model) {
        Mesh mesh = model.mesh();
        for (Mesh.Part part : mesh.parts()) {
            Map<List<Integer>, Integer> directed = new HashMap<>();
            double volume = 0;
            for (Mesh.Face face : part.faces()) {
                List<Integer> corners = face.corners();
                for (int i = 0; i < corners.size(); i++) {
                    directed.merge(List.of(corners.get(i), corners.get((i + 1) % corners.size())), 1, Integer::sum);
                }
                Point a = mesh.vertices().get(corners.get(0));
                for (int i = 1; i + 1 < corners.size(); i++) {
                    Point b = mesh.vertices().get(corners.get(i));
                    Point c = mesh.vertices().get(corners.get(i + 1));
                    assertThat(b.minus(a).cross(c.minus(a)).length())
                            .as("area in %s", part.name())
                            .isPositive();
                    volume += a.dot(b.cross(c)) / 6;
                }
            }
            // The skin of the church's air faces inward, so its volume counts as negative.
            boolean skin = part.name().equals("shell");
            assertThat(skin ? -volume : volume).as("volume of %s", part.name()).isPositive();
            directed.forEach((edge, count) -> {
                assertThat(count).as("edge %s of %s", edge, part.name()).isEqualTo(1);
                assertThat(directed).as("opposite of %s", edge).containsKey(List.of(edge.get(1), edge.get(0)));
            });
        }
    }

    @Test
    void theQuadrotorHasItsStatedSize() {
        Extent extent = QuadrotorModel.mesh().extent();

        assertThat(extent.size().x()).isCloseTo(0.60, within(1e-9));
        assertThat(extent.size().y()).isCloseTo(0.30, within(1e-9));
        assertThat(extent.size().z()).isCloseTo(0.40, within(1e-9));
        assertThat(extent.min().plus(extent.max()).length()).isCloseTo(0.0, within(1e-9));
    }

    @Test
    void theWingedCraftHaveTheirStatedSizes() {
        for (Mesh craft : List.of(FixedWingModel.mesh(), HybridGliderModel.mesh())) {
            Extent extent = craft.extent();
            boolean isGlider = craft.name().equals("hybrid-glider");

            assertThat(extent.size().x()).isCloseTo(isGlider ? 2.00 : 1.80, within(1e-9));
            assertThat(extent.size().y()).isCloseTo(isGlider ? 0.34 : 0.36, within(1e-9));
            assertThat(extent.size().z()).isCloseTo(isGlider ? 1.16 : 1.20, within(1e-9));
            assertThat(extent.min().plus(extent.max()).length()).isCloseTo(0.0, within(1e-9));
        }
    }

    /**
     * The volume of a straight wing is that of its section: 0.6851 t c2 for the four-digit thickness with a closed
     * edge.
     */
    @Test
    void aWingHasTheAreaOfItsSection() {
        List<Airfoil.Station> straight =
                List.of(new Airfoil.Station(new Point(0, 0, 0), 0.5), new Airfoil.Station(new Point(2, 0, 0), 0.5));
        // 10 t times the integral of 0.2969 sqrt(x) - 0.126 x - 0.3516 x2 + 0.2843 x3 - 0.1036 x4 from 0 to 1.
        double section = 10 * 0.12 * (0.2969 * 2 / 3 - 0.126 / 2 - 0.3516 / 3 + 0.2843 / 4 - 0.1036 / 5);

        double volume = new Airfoil(0.04, 0.12)
                .wing(new Material("skin", 1, 1, 1), straight)
                .signedVolume();

        // A polygon of 28 corners lies inside the curve.
        assertThat(Math.abs(volume)).isBetween(0.98 * section * 0.25 * 2, section * 0.25 * 2);
    }

    @Test
    void theHouseHasItsPlatform() {
        Mesh house = HouseModel.mesh();
        Extent extent = house.extent();

        assertThat(extent.min().y()).isEqualTo(-HouseModel.FOUNDATION_METRES);
        assertThat(topAt(house, 3.3, 2.2)).isCloseTo(HouseModel.ROOF_METRES, within(1e-9));
        assertThat(topAt(house, 0.1, 0.2)).isCloseTo(HouseModel.PLINTH_METRES, within(1e-9));
        assertThat(topAt(house, HouseModel.HALF_LENGTH_METRES - 0.1, 3.3))
                .isCloseTo(HouseModel.PARAPET_METRES, within(1e-9));
        assertThat(topAt(house, 3.3, 0.1 - HouseModel.HALF_DEPTH_METRES))
                .isCloseTo(HouseModel.PARAPET_METRES, within(1e-9));
    }

    /** Height of the highest face above a place. */
    private static double topAt(Mesh mesh, double x, double z) {
        double top = Double.NEGATIVE_INFINITY;
        int[] triangles = mesh.triangles();
        for (int i = 0; i < triangles.length; i += 3) {
            Point a = mesh.vertices().get(triangles[i]);
            Point b = mesh.vertices().get(triangles[i + 1]).minus(a);
            Point c = mesh.vertices().get(triangles[i + 2]).minus(a);
            double area = b.x() * c.z() - c.x() * b.z();
            double u = ((x - a.x()) * c.z() - c.x() * (z - a.z())) / area;
            double v = (b.x() * (z - a.z()) - (x - a.x()) * b.z()) / area;
            if (area != 0 && u >= 0 && v >= 0 && u + v <= 1) {
                top = Math.max(top, a.y() + u * b.y() + v * c.y());
            }
        }
        return top;
    }

    /** What models/README.md states is what the code computes, to the last digit that stands there. */
    @Thorough
    @Test
    void theFiguresOfTheReadmeAreTrue() throws IOException {
        String readme = Files.readString(SHIPPED.resolve("README.md"));
        for (Mesh craft : List.of(QuadrotorModel.mesh(), FixedWingModel.mesh(), HybridGliderModel.mesh())) {
            String section = readme.substring(readme.indexOf("## " + craft.name()));
            for (ProjectedArea.View view : ProjectedArea.View.values()) {
                assertThat(section.substring(0, section.indexOf("## ", 3)))
                        .contains(String.format(
                                Locale.ROOT,
                                "| %s | %.4f |",
                                view.name().toLowerCase(Locale.ROOT),
                                ProjectedArea.area(craft, view)));
            }
        }
        for (ModelCatalogue model : ModelCatalogue.all()) {
            Mesh mesh = model.mesh();
            Point size = mesh.extent().size();
            assertThat(readme)
                    .contains(String.format(
                            Locale.ROOT,
                            "| `%s.obj` | %,d | %.2f x %.2f x %.2f |",
                            mesh.name(),
                            mesh.triangleCount(),
                            size.x(),
                            size.z(),
                            size.y()));
        }
        Viewshed viewshed = new Viewshed(new HillTerrain());
        for (double height : new double[] {6, 12, 20}) {
            double hidden = 100 * viewshed.hiddenFraction(height, 700);
            assertThat(readme).contains(String.format(Locale.ROOT, "| %.0f m | %.0f %% |", height, hidden));
        }
    }
}
