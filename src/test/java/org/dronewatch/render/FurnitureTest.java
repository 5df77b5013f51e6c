package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.sensor.camera.Shapes;
import org.junit.jupiter.api.Test;

class FurnitureTest {
    private static final Position HERE = new Position(0, 0, 50);
    private static final ModelSettings MODEL = ModelSettings.of("none.obj");
    private static final KDTree BALL = KDTree.of(Shapes.sphere(0.2, 1));

    private static List<DroneMark> marks(int drones, int birds) {
        DroneSettings drone = DroneSettings.of(MODEL, Hover.at(HERE));
        DroneSettings bird = DroneSettings.bird(MODEL, Hover.at(HERE), 12.0, 0.005);
        List<DroneMark> marks = new ArrayList<>();
        for (int i = 0; i < drones + birds; i++) {
            Drone flying = (i < drones ? drone : bird).create("d" + i, BALL);
            marks.add(new DroneMark(flying, List.of(), List.of(), false));
        }
        return marks;
    }

    /** One line for each credit, in the lower right corner; a long one takes lines of at most half the width. */
    @Test
    void creditsStandInTheLowerRightCorner() {
        BufferedImage image = new BufferedImage(600, 400, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        Furniture furniture = new Furniture(g, 600, 400, 1.0);
        furniture.credits(List.of());
        assertThat(furniture.occupied()).isEmpty();

        String notice = "heights of the survey of a country with a long name, whose licence asks for a long notice";
        furniture.credits(List.of("© OpenStreetMap contributors", notice));
        assertThat(furniture.occupied()).hasSize(1);
        Rectangle paper = furniture.occupied().get(0);
        assertThat(paper.x + paper.width).isEqualTo(600 - 12);
        assertThat(paper.y + paper.height).isEqualTo(400 - 12);
        assertThat(paper.width).isLessThanOrEqualTo(300 + 12);
        List<String> lines = Credits.lines(List.of(notice), g.getFontMetrics(), 300);
        assertThat(lines)
                .hasSizeGreaterThan(1)
                .allMatch(line -> g.getFontMetrics().stringWidth(line) <= 300);
        assertThat(String.join(" ", lines)).isEqualTo(notice);
        assertThat(paper.height).isEqualTo(13 * (1 + lines.size()) + 7);
        assertThat(Credits.lines(List.of("unbreakable"), g.getFontMetrics(), 5)).containsExactly("unbreakable");
        g.dispose();
    }

    @Test
    void theLegendCountsBirdsApartFromDrones() {
        assertThat(Furniture.flying(marks(1, 0))).containsOnlyKeys("drone");
        assertThat(Furniture.flying(marks(3, 0))).containsOnlyKeys("drones: 3");
        assertThat(Furniture.flying(marks(2, 1)))
                .containsExactly(entry("drones: 2", KindColours.DRONE), entry("bird", KindColours.BIRD));
        assertThat(Furniture.flying(marks(1, 12))).containsOnlyKeys("drone", "birds: 12");
        assertThat(Furniture.flying(marks(0, 4))).containsOnlyKeys("birds: 4");
        assertThat(Furniture.flying(marks(0, 0))).containsOnlyKeys("drones: 0");
    }
}
