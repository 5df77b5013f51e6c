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
import org.dronewatch.fusion.Alert;
import org.dronewatch.fusion.AlertRule;
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
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarFalseAlarms;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;
import org.junit.jupiter.api.Test;

/**
 * Everything but scoring is the same whatever the truth beside the measurements says, as long as association can read
 * which of them belong together: a radar cues two cameras on positioners, and alerts are raised, with false alarms and
 * by every rule.
 */
class HiddenTruthTest {
    private static final Position MAST = new Position(0, 0, 30);
    private static final AlertSettings ANY = AlertSettings.DEFAULT;
    private static final AlertSettings TWO =
            ANY.withRule(AlertRule.SeveralSensors.of(2)).withConfirmation(2, 3);
    private static final AlertSettings UNION = ANY.withRule(AlertRule.UnionOfProbabilities.of(0.2));

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
     * That of false alarms, which are added to what a sensor observes, remains.
     */
    private static final class TruthForAssociation extends PerfectAssociation implements Disguise {
        private final Map<LookId, List<GroundTruth>> truths = new ConcurrentHashMap<>();

        TruthForAssociation(AlertSettings rule) {
            super(rule.confirm().looks());
        }

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
                    .map(one -> one.truth() != null
                            ? one
                            : withTruth(one, left.get(one.look()).next()))
                    .toList();
            return super.associate(restored, looked, time);
        }
    }

    private static final class Site extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final transient AlertSettings alert;
        private final transient Disguise disguise;

        Site(AlertSettings alert, Disguise disguise) {
            this.alert = alert;
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
                    .withDetection(new RadarDetection.Chance(1e-6, 1))
                    .withFalseAlarms(RadarFalseAlarms.DEFAULT.withCells(100_000))
                    .withRate(2.0);
            PositionerSettings cued = PositionerSettings.DEFAULT.withCues("radar");
            CameraSettings camera = CameraSettings.at(MAST)
                    .withResolution(640, 360)
                    .withFalseAlarms(new FalseAlarms(5000, 1000, 0.4))
                    .withRate(5.0);
            put("radar", radar);
            put("first", camera.withPositioner(cued));
            put("second", camera.withHorizontalFov(0.1).withPositioner(cued));
            setAlert(alert);
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
        return outputs(ANY, disguise);
    }

    private Outputs outputs(AlertSettings rule, Disguise disguise) {
        List<String> measured = new ArrayList<>();
        List<String> pointed = new ArrayList<>();
        SceneResult result = new SceneRunner(new Site(rule, disguise))
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

    /**
     * What a stage does without scoring.
     *
     * @param raised all alerts, false ones among them
     */
    private record Unscored(Outputs outputs, List<Alert> raised) {}

    /** The same without scoring: the looks of the stage, what positioners do, and the alerts. */
    private Unscored unscored(AlertSettings rule, Disguise disguise, PerfectAssociation association) {
        SceneSettings settings = new Site(rule, disguise).describe();
        Stage stage = new Stage(
                settings,
                new ModelCache(FloorScene.MODELS, note -> {}),
                settings.run().seed(),
                association);
        List<String> measured = new ArrayList<>();
        List<String> pointed = new ArrayList<>();
        List<Alert> raised = new ArrayList<>();
        LookTimes times = new LookTimes();
        for (double time = 0.0; time <= settings.run().duration(); time = stage.nextLook()) {
            stage.look(time, stage.dronesAt(time), times)
                    .forEach(seen -> measured.add(seen.measurements() + " " + seen.figures()));
            pointed.add(time + " " + stage.pointings());
            raised.addAll(stage.raised());
        }
        Map<String, String> alerts = Map.of(
                "near", alert(stage, association, "near"),
                "far", alert(stage, association, "far"));
        return new Unscored(new Outputs(measured, pointed, alerts), raised);
    }

    private static String alert(Stage stage, PerfectAssociation association, String drone) {
        return stage.alerts().alert(association.contactOf(drone).orElseThrow()).toString();
    }

    @Test
    void aTruthThatThrowsWhenItIsReadOutsideAssociationChangesNothing() {
        TruthForAssociation hidden = new TruthForAssociation(ANY);
        Observation unreadable = hidden.of(List.of(new Observation(
                        new LookId("radar", "radar", 0, 0.0), "near", 1.0, new Reading(1.0, 0.0, "dB"))))
                .get(0);
        assertThatThrownBy(unreadable::drone).isInstanceOf(NullPointerException.class);
        assertThatThrownBy(unreadable::isFalse).isInstanceOf(NullPointerException.class);

        for (AlertSettings rule : List.of(ANY, TWO)) {
            Unscored told = unscored(rule, Disguise.NONE, association(rule));
            assertThat(told.outputs()).isEqualTo(outputs(rule, Disguise.NONE));
            assertThat(told.raised()).as("false alerts, too").hasSizeGreaterThan(3);

            TruthForAssociation association = new TruthForAssociation(rule);
            assertThat(unscored(rule, association, association)).isEqualTo(told);
        }
    }

    /**
     * How likely a look was to detect a drone that it did not detect, no sensor knows: the alerts that follow from it
     * are scores, which a stage does not have.
     */
    @Test
    void whatIsKnownOfLooksThatDetectNothingRaisesNoAlertOfTheSystem() {
        Outputs scored = outputs(UNION, Disguise.NONE);
        assertThat(scored.alerts().values()).noneMatch(alert -> alert.contains("empty"));

        Unscored told = unscored(UNION, Disguise.NONE, association(UNION));
        assertThat(told.raised()).isEmpty();
        assertThat(told.outputs().pointed()).isEqualTo(scored.pointed());
        Unscored unassessed = unscored(
                UNION,
                seen -> seen.stream().map(one -> one.withFigures(Map.of())).toList(),
                association(UNION));
        assertThat(unassessed.outputs().pointed()).isEqualTo(told.outputs().pointed());
        assertThat(unassessed.raised()).isEmpty();
    }

    private static PerfectAssociation association(AlertSettings rule) {
        return new PerfectAssociation(rule.confirm().looks());
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
