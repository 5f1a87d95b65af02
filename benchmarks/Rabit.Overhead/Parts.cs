using System;

namespace Rabit.Overhead;

/// <summary>What runs beside the managers of a flight.</summary>
[Flags]
internal enum Parts
{
    /// <summary>The flight alone.</summary>
    None = 0,

    /// <summary>In a .NET host: log by ILogger, health checks every five seconds, notifications to systemd.</summary>
    Hosting = 1,

    /// <summary>The live page, and one browser.</summary>
    Page = 2,

    /// <summary>The diagnostics, and one tool that asks for the status every second, as "rabit top".</summary>
    Tool = 4,

    /// <summary>Nineteen browsers beside that of <see cref="Page"/>.</summary>
    NineteenMore = 8,

    /// <summary>Hosting, page and diagnostics.</summary>
    All = Hosting | Page | Tool,

    /// <summary>The live page, and twenty browsers.</summary>
    TwentyBrowsers = Page | NineteenMore,
}
