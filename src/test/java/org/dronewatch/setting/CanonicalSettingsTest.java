package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class CanonicalSettingsTest {
    private enum Colour {
        RED
    }

    private record Inner(double x, int n) {}

    private record Outer(
            Optional<Inner> maybe,
            List<Inner> list,
            Map<String, Double> map,
            Colour colour,
            String text,
            Object function,
            boolean yes) {}

    private static Outer outer(Optional<Inner> maybe, String text) {
        Map<String, Double> map = new LinkedHashMap<>();
        map.put("b", 0.1 + 0.2);
        map.put("a", -0.0);
        DoubleUnaryOperator function = x -> x;
        return new Outer(maybe, List.of(new Inner(1e-300, -1)), map, Colour.RED, text, function, true);
    }

    @Test
    void isALineForEachValue() {
        assertThat(CanonicalSettings.of(outer(Optional.of(new Inner(Double.NaN, 7)), "a\nb=c\\")))
                .isEqualTo(
                        """
                        maybe=Inner
                        maybe.x=NaN
                        maybe.n=7
                        list=list of 1
                        list.0=Inner
                        list.0.x=1.0E-300
                        list.0.n=-1
                        map=map of 2
                        map.b=0.30000000000000004
                        map.a=-0.0
                        colour=RED
                        text=a\\nb=c\\\\
                        function=function
                        yes=true
                        """);
    }

    @Test
    void tellsNoneFromItsName() {
        assertThat(CanonicalSettings.of(outer(Optional.empty(), "x"))).startsWith("maybe=none\nlist=");
        assertThat(CanonicalSettings.of(outer(Optional.empty(), "x\nyes=false")))
                .isNotEqualTo(CanonicalSettings.of(outer(Optional.empty(), "x")));
    }
}
