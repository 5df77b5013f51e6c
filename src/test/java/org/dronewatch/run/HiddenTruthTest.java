package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.UnaryOperator;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.time.LookTimes;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.FloorScene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;
import org.junit.jupiter.api.Test;

/**
 * Everything but scoring is the same whatever the truth beside the measurements says, as long as association can read
 * which of them belong together: a radar cues two cameras on positioners, and alerts are raised.
 */
class HiddenTruthTest {
    private static final Position MAST = new Position(0, 0, 30);

    /** What becomes of a sensor's observations after each look. */
    @FunctionalInterface
    private interface Disguise {
        Disguise NONE = seen -> seen;

        List<Observation> of(List<Observation> seen);

        /** The truth of each observation becomes another. */
        static Disguise ofTruth(UnaryOperator<GroundTruth> other) {
            return seen -> seen.stream()
                    .map(one -> withTruth(one, other.apply(one.truth())))
                    .toList();
        }
    }

    private static Observation withTruth(Observation seen, GroundTruth truth) {
        return new Observation(seen.look(), truth, seen.reading(), seen.figures(), seen.sighting());
    }

    /** A sensor that is like another, but for the truth beside its measurements. */
    private record Disguised(SensorSettings<?> real, Disguise disguise) implements SensorSettings<Sensor> {
        @Override
        public Position position() {
            return real.position();
        }

        @Override
        public Disguised withPosition(Position other) {
            return new Disguised(real.withPosition(other), disguise);
        }

        @Override
        public double rate() {
            return real.rate();
        }

        @Override
        public String kind() {
            return real.kind();
        }

        @Override
        public <C> Optional<C> as(Class<C> capability) {
            return real.as(capability);
        }

        @Override
        public Sensor create() {
            Sensor sensor = real.create();
            return (world, drones, look) -> disguise.of(sensor.observe(world, drones, look));
        }
    }

    /**
     * Takes the truth from observations, so that whoever reads it fails, and gives it back for the association alone.
     */
    private static final class TruthForAssociation extends PerfectAssociation implements Disguise {
        private final Map<LookId, List<GroundTruth>> truths = new ConcurrentHashMap<>();

        @Override
        public List<Observation> of(List<Observation> seen) {
            if (!seen.isEmpty()) {
                truths.put(
                        seen.get(0).look(),
                        seen.stream().map(Observation::truth).toList());
            }
            return seen.stream().map(one -> withTruth(one, null)).toList();
        }

        @Override
        public List<ContactLook> associate(List<Observation> observations, Collection<String> looked, double time) {
            Map<LookId, Iterator<GroundTruth>> left = new HashMap<>();
            truths.forEach((look, ofLook) -> left.put(look, ofLook.iterator()));
            truths.clear();
            List<Observation> restored = observations.stream()
                    .map(one -> withTruth(one, left.get(one.look()).next()))
                    .toList();
            return super.associate(restored, looked, time);
        }
    }

    private static final class Site extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final transient Disguise disguise;

        Site(Disguise disguise) {
            this.disguise = disguise;
        }

        @Override
        protected void build() {
            loadFloor();
            fly("near", new Position(-40, 90, 50), new Position(-10, 20, 40));
            fly("far", new Position(60, 160, 60), new Position(20, 40, 45));
            RadarSettings radar = RadarSettings.at(MAST, LinkBudget.DataSheet.of(150, 0.01))
                    .withFieldOfView(2.5, 1.5)
                    .withSpeeds(0, 100)
                    .withRate(2.0);
            PositionerSettings cued = PositionerSettings.DEFAULT.withCues("radar");
            CameraSettings camera =
                    CameraSettings.at(MAST).withResolution(640, 360).withRate(5.0);
            put("radar", radar);
            put("first", camera.withPositioner(cued));
            put("second", camera.withHorizontalFov(0.1).withPositioner(cued));
            setAlert(AlertSettings.DEFAULT);
            setRun(RunSettings.DEFAULT.withDuration(8.0).withSeed(11));
        }

        private void fly(String name, Position from, Position to) {
            add(
                    name,
                    DroneSettings.of(loadPackaged("quadrotor.obj"), new Approach(from, to))
                            .withSpeed(8.0));
        }

        private void put(String name, SensorSettings<?> sensor) {
            add(name, new Disguised(sensor, disguise));
        }
    }

    /** All that is measured and pointed, and the alerts by their drone. */
    private record Outputs(List<String> measured, List<String> pointed, Map<String, String> alerts) {}

    private Outputs outputs(Disguise disguise) {
        List<String> measured = new ArrayList<>();
        List<String> pointed = new ArrayList<>();
        SceneResult result = new SceneRunner(new Site(disguise))
                .onFrame((Frame frame) -> {
                    frame.observations().forEach(seen -> measured.add(seen.measurements() + " " + seen.figures()));
                    pointed.add(frame.time() + " " + frame.pointings());
                })
                .run();
        return new Outputs(
                measured,
                pointed,
                Map.of(
                        "near", result.alert("near").alert().toString(),
                        "far", result.alert("far").alert().toString()));
    }

    /** The same without scoring: the looks of the stage, what positioners do, and the alerts. */
    private Outputs unscored(Disguise disguise, PerfectAssociation association) {
        SceneSettings settings = new Site(disguise).describe();
        Stage stage = new Stage(
                settings,
                new ModelCache(FloorScene.MODELS, note -> {}),
                settings.run().seed(),
                association);
        List<String> measured = new ArrayList<>();
        List<String> pointed = new ArrayList<>();
        LookTimes times = new LookTimes();
        for (double time = 0.0; time <= settings.run().duration(); time = stage.nextLook()) {
            stage.look(time, stage.dronesAt(time), times)
                    .forEach(seen -> measured.add(seen.measurements() + " " + seen.figures()));
            pointed.add(time + " " + stage.pointings());
        }
        return new Outputs(
                measured,
                pointed,
                Map.of("near", alert(stage, association, "near"), "far", alert(stage, association, "far")));
    }

    private static String alert(Stage stage, PerfectAssociation association, String drone) {
        return stage.alerts().alert(association.contactOf(drone).orElseThrow()).toString();
    }

    @Test
    void aTruthThatThrowsWhenItIsReadOutsideAssociationChangesNothing() {
        Outputs told = outputs(Disguise.NONE);
        assertThat(unscored(Disguise.NONE, new PerfectAssociation())).isEqualTo(told);

        TruthForAssociation hidden = new TruthForAssociation();
        Observation unreadable = hidden.of(List.of(new Observation(
                        new LookId("radar", "radar", 0, 0.0), "near", 1.0, new Reading(1.0, 0.0, "dB"))))
                .get(0);
        assertThatThrownBy(unreadable::drone).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(unreadable::isFalse).isInstanceOf(NullPointerException.class);

        TruthForAssociation association = new TruthForAssociation();
        assertThat(unscored(association, association)).isEqualTo(told);
    }

    @Test
    void aTruthThatSaysSomethingElseChangesNothingButTheScores() {
        Outputs told = outputs(Disguise.NONE);
        assertThat(told.pointed()).as("positioners turn").hasSizeGreaterThan(30).doesNotHaveDuplicates();
        assertThat(told.alerts().values()).doesNotHaveDuplicates().noneMatch(alert -> alert.contains("empty"));

        Outputs lost = outputs(Disguise.ofTruth(truth -> new GroundTruth(truth.drone(), Double.NaN, Double.NaN)));
        assertThat(lost).as("neither range nor time").isEqualTo(told);

        Outputs renamed = outputs(Disguise.ofTruth(truth ->
                new GroundTruth(truth.drone().equals("near") ? "far" : "near", -1e9 * truth.range(), -truth.time())));
        assertThat(renamed.measured()).isEqualTo(told.measured());
        assertThat(renamed.pointed()).isEqualTo(told.pointed());
        assertThat(renamed.alerts().get("far")).isEqualTo(told.alerts().get("near"));
        assertThat(renamed.alerts().get("near")).isEqualTo(told.alerts().get("far"));
    }
}
