package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.entry;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
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
