/** The searches of the commands place and route, which may take long and can be stopped. */
package org.dronewatch.app.search;
