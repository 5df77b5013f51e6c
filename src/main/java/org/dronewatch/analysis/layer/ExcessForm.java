package org.dronewatch.analysis.layer;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.store.StoreReader;
import org.dronewatch.run.store.StoreWriter;
import org.dronewatch.run.store.StoredForm;
import org.dronewatch.sensor.Signal;

/** The form in which an {@link ExcessMap} is kept: its places, then those held out, each as doubles. */
final class ExcessForm implements StoredForm<ExcessMap> {
    /** The only form. */
    static final ExcessForm FORM = new ExcessForm();

    private static final String UNIT = "dB";
    private static final int NUMBERS = 12;

    private ExcessForm() {}

    @Override
    public void write(ExcessMap value, StoreWriter target) throws IOException {
        target.addDoubles(all(value.places()));
        target.addDoubles(all(value.heldOut()));
    }

    @Override
    public ExcessMap read(StoreReader source) throws IOException {
        return new ExcessMap(places(source.nextDoubles()), places(source.nextDoubles()));
    }

    private static double[] all(List<TracedPlace> places) {
        return places.stream().flatMapToDouble(ExcessForm::numbers).toArray();
    }

    private static DoubleStream numbers(TracedPlace place) {
        Signal signal = place.signal();
        return DoubleStream.of(
                place.at().x(),
                place.at().y(),
                place.at().z(),
                place.isInSight() ? 1.0 : 0.0,
                place.overOpen(),
                place.exact(),
                place.rest(),
                signal.probability(),
                signal.quantity(),
                signal.threshold(),
                signal.standardError(),
                signal.probabilityError());
    }

    private static List<TracedPlace> places(double[] numbers) {
        if (numbers.length % NUMBERS != 0 || DoubleStream.of(numbers).anyMatch(Double::isNaN)) {
            throw new IllegalArgumentException("incomplete list of positions");
        }
        List<TracedPlace> places = new ArrayList<>();
        for (int at = 0; at < numbers.length; at += NUMBERS) {
            int number = at + 3;
            boolean isInSight = numbers[number++] == 1.0;
            double overOpen = numbers[number++];
            double exact = numbers[number++];
            double rest = numbers[number++];
            Signal signal = new Signal(
                    numbers[number++], numbers[number++], UNIT, numbers[number++], numbers[number++], numbers[number]);
            Position position = new Position(numbers[at], numbers[at + 1], numbers[at + 2]);
            places.add(new TracedPlace(position, isInSight, signal, overOpen, exact, rest));
        }
        return places;
    }
}
