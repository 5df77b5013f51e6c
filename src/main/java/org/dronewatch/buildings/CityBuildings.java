package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.buildings.io.CityModel;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.TerrainGround;

/** Converts the solids of a city model, whose heights are above sea level, to triangles in the world frame. */
final class CityBuildings {
    private final BuildingSettings settings;
    private final CityModel model;
    private final double[] vertices;
    private final BuildingReport report;
    private final List<Double> floors = new ArrayList<>();

    /**
     * The vertices of a model in the world frame.
     *
     * @throws InputException when one lies where the system has no coordinates
     */
    CityBuildings(CityModel model, BuildingSettings settings, MapTransform transform, BuildingReport report) {
        this.settings = settings;
        this.model = model;
        this.report = report;
        this.vertices = new double[model.vertices().length];
        for (int i = 0; i < vertices.length; i += 3) {
            Position position = transform.inWorld(
                    model.vertices()[i], model.vertices()[i + 1], model.vertices()[i + 2] + settings.verticalOffset());
            vertices[i] = position.x();
            vertices[i + 1] = position.y();
            vertices[i + 2] = position.z();
        }
    }

    /** The solids near the origin as one mesh; compares their lowest points with the ground. */
    TriangleMesh mesh(Optional<TerrainGround> ground) {
        float[] floats = new float[vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            floats[i] = (float) vertices[i];
        }
        Ints all = new Ints();
        for (CityModel.Solid solid : model.solids()) {
            if (isNear(solid)) {
                CitySolid cut = CitySolid.of(solid.surfaces(), vertices);
                if (cut.corners().length == 0) {
                    report.leave("building without a surface");
                    continue;
                }
                for (int corner : cut.corners()) {
                    all.add(corner);
                }
                report.add(cut, upwardArea(cut.corners()), CityOutlines.of(solid.id(), cut.corners(), vertices));
                if (!cut.isClosed()) {
                    report.doubt("the solid is not closed", solid.id());
                }
                if (!cut.isWhole()) {
                    report.doubt("a surface crosses itself, so it may have gaps", solid.id());
                }
                ground.ifPresent(level -> compare(cut.corners(), level));
            }
        }
        report.floors(floors);
        int[] corners = all.toArray();
        int[] numbers = new int[corners.length / 3];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = i;
        }
        return new TriangleMesh(floats, corners, new int[numbers.length], numbers, List.of(settings.material()));
    }

    private boolean isNear(CityModel.Solid solid) {
        return solid.surfaces().stream().anyMatch(surface -> {
            List<double[]> rings = surface.stream()
                    .map(corners -> CitySolid.flat(corners, vertices))
                    .toList();
            return !rings.isEmpty()
                    && Rings.isWithin(settings.radius(), rings.subList(0, 1), rings.subList(1, rings.size()));
        });
    }

    /** The area of what faces upwards, as seen from above, m2. */
    private double upwardArea(int[] corners) {
        double area = 0.0;
        for (int i = 0; i < corners.length; i += 3) {
            int a = 3 * corners[i];
            int b = 3 * corners[i + 1];
            int c = 3 * corners[i + 2];
            area += 0.5
                    * Math.max(
                            0.0,
                            (vertices[b] - vertices[a]) * (vertices[c + 1] - vertices[a + 1])
                                    - (vertices[b + 1] - vertices[a + 1]) * (vertices[c] - vertices[a]));
        }
        return area;
    }

    /** Records how far the lowest corner lies above the ground below it. */
    private void compare(int[] corners, TerrainGround ground) {
        int lowest = corners[0];
        for (int vertex : corners) {
            lowest = vertices[3 * vertex + 2] < vertices[3 * lowest + 2] ? vertex : lowest;
        }
        double level = ground.heightAt(vertices[3 * lowest], vertices[3 * lowest + 1]);
        if (!Double.isNaN(level)) {
            floors.add(vertices[3 * lowest + 2] - level);
        }
    }
}
