package org.dronewatch.placement.plan;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.scenario.SceneCondition;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.ConditionedScene;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.SceneByName;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;

/**
 * A placement file with its scene and its candidates. The site is loaded only if positions are given relative to its
 * surface.
 *
 * @param settings settings in the file
 * @param scene the scene that the file names
 * @param runner runner of that scene
 * @param present settings of the scene as it is
 * @param drone the drone that is to be detected
 * @param candidates the candidates: first the sensors that are kept, then the others in the order of the file
 * @param conditions further conditions under which the airspace is to be covered; none if only the scene as it is
 *     counts
 * @param conditionsFile file of these conditions; empty if there is none
 */
public record PlacePlan(
        PlaceSettings settings,
        Scene scene,
        SceneRunner runner,
        SceneSettings present,
        String drone,
        List<SiteCandidate> candidates,
        List<ConditionedScene> conditions,
        Optional<Path> conditionsFile) {
    private static final String SCENE = "scene";
    private static final Pattern PLACED =
            Pattern.compile("(scene|drone|objective|budget|candidates|keep|conditions|air)[.: ]");

    /** Copies the lists: later changes by the caller have no effect. */
    public PlacePlan {
        candidates = List.copyOf(candidates);
        conditions = List.copyOf(conditions);
    }

    /**
     * Whether sensors on positioners have turned to the drone or search for it. Unless the plan says otherwise, they
     * search if the objective is {@code weakest-route}, since nothing has cued them before the first detection, as
     * {@code route} assumes; for the other objectives, they have turned to the drone.
     */
    public FieldTerms.Turning pointing() {
        return settings.air()
                .pointing()
                .orElse(
                        settings.objective() == PlaceObjective.WEAKEST_ROUTE
                                ? FieldTerms.Turning.SEARCH
                                : FieldTerms.Turning.CUED);
    }

    /** Whether a layout within the budget must also meet conditions, or have a minimum number of some sensors. */
    public boolean hasConditions() {
        return !settings.conditions().equals(LayoutConditions.NONE)
                || settings.candidates().values().stream().anyMatch(offer -> offer.atLeast() > 0);
    }

    /** All sensors that the scene has now or that a layout may have. */
    public List<SensorSettings<?>> sensors() {
        List<SensorSettings<?>> sensors =
                new ArrayList<>(present.enabledSensors().values());
        candidates.forEach(candidate -> sensors.add(candidate.sensor()));
        return sensors;
    }

    /**
     * Reads a file.
     *
     * @param configuration is applied to the runner of the scene, and may override what the file of the scene specifies
     * @param notes receives a line for each file read, and each warning
     * @throws InputException with a line for each error: file, line, column, setting, value and limit
     */
    public static PlacePlan read(Path file, Consumer<SceneRunner> configuration, Consumer<String> notes) {
        Path directory = file.toAbsolutePath().normalize().resolveSibling("");
        Node.Mapping document = SettingsFile.document(file);
        String name = document.text(SCENE).orElse("");
        if (name.isEmpty()) {
            // Reports that it is missing, together with other mistakes that show without it.
            SettingsFile.read(document, PlaceSettings.class, Kinds.FOUND, directory, new FormerNames());
            throw new InputException(PlainText.value(file) + ": scene: is empty");
        }
        Scene scene = scene(document, directory, name);
        SceneRunner runner = runner(scene, configuration).notes(notes);
        SceneSettings present = runner.settings().withoutSweep();
        Kinds kinds = runner.kinds(SensorKinds.kinds(Catalog.beside(directory)), present);
        PlaceSettings settings = SettingsFile.read(document, PlaceSettings.class, kinds, directory, new FormerNames());
        try {
            CandidatesOnSite found = new CandidatesOnSite(settings, present, runner, kinds, directory);
            String drone = drone(settings, present);
            Optional<Path> weather = settings.air().conditionsFile(directory);
            List<ConditionedScene> conditions = ConditionedScene.of(
                    weather.map(SceneCondition::read).orElse(List.of()),
                    () -> runner(scene(document, directory, name), configuration),
                    drone);
            return new PlacePlan(settings, scene, runner, present, drone, found.all(), conditions, weather);
        } catch (InputException e) {
            throw placed(file, e);
        }
    }

    private static SceneRunner runner(Scene scene, Consumer<SceneRunner> configuration) {
        SceneRunner runner = new SceneRunner(scene);
        configuration.accept(runner);
        return runner;
    }

    /**
     * A problem that comes up when candidates are assessed or chosen, preceded by the location, in the file, of the
     * first setting that its message names.
     *
     * @param file the file that was read
     */
    public static InputException placed(Path file, InputException problem) {
        String message = String.valueOf(problem.getMessage());
        return PLACED.matcher(message).lookingAt()
                ? new InputException(SettingsFile.document(file).markOf(message) + ": " + message, problem)
                : problem;
    }

    private static Scene scene(Node.Mapping document, Path directory, String name) {
        try {
            return SceneByName.of(directory, name, "placement file");
        } catch (InputException e) {
            throw new InputException(document.markOf(SCENE) + ": " + e.getMessage(), e);
        }
    }

    private static String drone(PlaceSettings settings, SceneSettings present) {
        var drones = present.individualDrones().keySet();
        if (settings.drone().isPresent() && !drones.contains(settings.drone().get())) {
            String name = settings.drone().get();
            throw new InputException("drone " + PlainText.value(name) + ": there is no such drone; "
                    + Spelling.closestMatches(name, drones));
        }
        return settings.drone()
                .or(() -> FieldRequest.firstDrone(present))
                .orElseThrow(() -> new InputException("scene: has no drone that could be detected"));
    }

    /** This plan with another budget. */
    public PlacePlan withBudget(double budget) {
        return with(settings.withBudget(budget));
    }

    /** This plan with another cell size: the length of a cell's side, m. */
    public PlacePlan withCell(double length) {
        return with(SettingsForm.with(settings, "air", SettingsForm.with(settings.air(), "cell", Optional.of(length))));
    }

    private PlacePlan with(PlaceSettings others) {
        return new PlacePlan(others, scene, runner, present, drone, candidates, conditions, conditionsFile);
    }
}
