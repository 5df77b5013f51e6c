package org.dronewatch.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.models.ProjectedArea.View;
import org.junit.jupiter.api.Test;

class ProjectedAreaTest {
    private static final Material ANY = new Material("any", 0.5, 0.5, 0.5);

    private static Mesh mesh(Solid... solids) {
        MeshBuilder builder = new MeshBuilder("test", 6);
        for (int i = 0; i < solids.length; i++) {
            builder.add("part" + i, solids[i]);
        }
        return builder.build();
    }

    @Test
    void aBoxCoversItsFaces() {
        Mesh box = mesh(Solids.box(ANY, new Point(0, 0, 0), new Point(2, 3, 5)));

        assertThat(ProjectedArea.area(box, View.FRONT)).isCloseTo(6.0, within(1e-3));
        assertThat(ProjectedArea.area(box, View.SIDE)).isCloseTo(15.0, within(1e-3));
        assertThat(ProjectedArea.area(box, View.TOP)).isCloseTo(10.0, within(1e-3));
    }

    @Test
    void whatOverlapsCountsOnce() {
        Mesh two = mesh(
                Solids.box(ANY, new Point(0, 0, 0), new Point(2, 2, 1)),
                Solids.box(ANY, new Point(1, 1, 5), new Point(3, 3, 6)));

        assertThat(ProjectedArea.area(two, View.FRONT)).isCloseTo(4 + 4 - 1, within(1e-3));
    }

    @Test
    void apartIsAdded() {
        Mesh two = mesh(
                Solids.box(ANY, new Point(0, 0, 0), new Point(1, 1, 1)),
                Solids.box(ANY, new Point(5, 0, 0), new Point(6, 1, 1)));

        assertThat(ProjectedArea.area(two, View.FRONT)).isCloseTo(2.0, within(1e-3));
    }

    /** A regular polygon of n corners on a circle of radius r covers n/2 r^2 sin(2 pi / n). */
    @Test
    void aCylinderCoversItsPolygon() {
        Mesh cylinder = mesh(Solids.cylinder(ANY, new Point(0, 0, 0), 0.5, 2, 40));

        double polygon = 20 * 0.25 * StrictMath.sin(2 * StrictMath.PI / 40);
        assertThat(ProjectedArea.area(cylinder, View.TOP)).isCloseTo(polygon, within(1e-5));
    }

    @Thorough
    @Test
    void aBallCoversADisc() {
        List<double[]> profile = new ArrayList<>();
        for (int i = 0; i < 140; i++) {
            double angle = StrictMath.PI * (i + 0.5) / 140;
            profile.add(new double[] {StrictMath.sin(angle), -StrictMath.cos(angle)});
        }
        Mesh ball = mesh(Solids.turned(ANY, new Point(0, 0, 0), profile.toArray(new double[0][]), 140));

        for (View view : View.values()) {
            assertThat(ProjectedArea.area(ball, view)).isCloseTo(StrictMath.PI, within(2e-3));
        }
    }
}
