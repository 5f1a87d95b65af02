using System;
using Rabit.Mavlink;

namespace Rabit.Tool.Geolocation;

/// <summary>A frame that a log has of our vehicle.</summary>
/// <param name="Frame">The frame.</param>
/// <param name="Stamp">When it was recorded, since 1970.</param>
/// <param name="IsOfAutopilot">Whether the autopilot sent it, no other component.</param>
internal readonly record struct LoggedFrame(MavlinkFrame Frame, TimeSpan Stamp, bool IsOfAutopilot);
