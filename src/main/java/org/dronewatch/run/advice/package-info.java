/** Hints about what only the site and the flights reveal, such as a path that enters the ground. */
package org.dronewatch.run.advice;
