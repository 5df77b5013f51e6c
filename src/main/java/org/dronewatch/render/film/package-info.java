/** Films: pictures one after another, in a file that browsers and players show. */
package org.dronewatch.render.film;
