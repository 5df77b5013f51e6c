package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignResult;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.report.campaign.CampaignFile;
import org.dronewatch.report.campaign.ComparedVariants;
import org.dronewatch.run.Stage;
import org.dronewatch.setting.Counted;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for placements found, and how often the layout and the scene's own sensors succeed against the same
 * attacks.
 *
 * @param found what the search found
 * @param plan the campaign, whose variants are the layouts
 * @param result the results of the campaign
 * @param again the arguments that follow the layout in the {@code compare} command that reproduces the figures of the
 *     campaign
 */
public record AttackedPlaceResults(PlaceResults found, CampaignPlan plan, CampaignResult result, String again)
        implements FoundPlaceResults {
    @Override
    public PlaceResults without(LeftOut part, SolverLimits limits) {
        return new AttackedPlaceResults(found.without(part, limits), plan, result, again);
    }

    @Override
    public boolean isInterrupted() {
        return found.isInterrupted() || !result.stopping().isReached() && !front().isWithout(LeftOut.ATTACKS);
    }

    /** {@inheritDoc} The key {@code campaign} has the contents of {@code campaign.json}. */
    @Override
    public ObjectNode toJson() {
        ObjectNode root = found.toJson();
        root.set("campaign", new CampaignFile(plan, result).toJson());
        root.remove(PlaceFile.COMPLETE);
        root.put(PlaceFile.COMPLETE, complete());
        return root;
    }

    @Override
    public PlaceChapter chapter(Stage stage) throws IOException {
        PlaceChapter chapter = found.chapter(stage);
        ComparedVariants variants = new ComparedVariants(result.summary());
        List<PlaceChapter.Section> sections = new ArrayList<>(chapter.sections());
        sections.add(new PlaceChapter.Section(
                "The same attacks against the layout" + (plan.variants().size() > 1 ? " and today's sensors" : ""),
                variants.html()));
        List<String> scope = new ArrayList<>(chapter.scope());
        scope.add("The attacks are " + Counted.of(flown(), "run") + " of the scene with each layout, with values"
                + " drawn at random: " + String.join(", ", plan.paths()) + ".");
        scope.addAll(variants.doubts());
        return new PlaceChapter(
                (chapter.verdict() + " " + variants.verdict()).strip(), chapter.pictures(), sections, scope);
    }

    /** The number of attacks that were flown against each layout. */
    private int flown() {
        return result.summary().variants().values().iterator().next().cases();
    }

    @Override
    public List<String> reproduction(String layout) {
        List<String> sentences = new ArrayList<>(found.reproduction(layout));
        sentences.add(sentence(layout));
        return sentences;
    }

    /**
     * The command that reproduces the figures of the campaign, in a sentence.
     *
     * @param layout the file of the layout, as a command-line argument, quoted if necessary
     */
    public String sentence(String layout) {
        return "This command gives the same figures for the attacks, and the deciding cases: dronewatch compare "
                + layout + " " + again;
    }
}
