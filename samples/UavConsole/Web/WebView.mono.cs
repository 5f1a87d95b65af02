using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Communications;

namespace UavConsole;

/// <summary>There is no live page here: ASP.NET Core, which serves it, runs on .NET only.</summary>
internal sealed class WebView : IDisposable
{
    private WebView()
    {
    }

    /// <summary>For people.</summary>
    public string Address => string.Empty;

    public static string? FindFault(WebChoices choices)
        => $"--web {choices.Address}".TrimEnd() + " needs .NET 10: its server, ASP.NET Core, does not run under Mono.";

    public static IReadOnlyList<MavlinkSubscription> SubscriptionsOf(WebChoices? choices) => [];

    public static WebView? Open(WebChoices? choices) => null;

    public void Log(RabitLogEntry entry)
    {
    }

    public void Add(RabitReactor reactor, Flight flight, bool mayCommand)
    {
    }

    public void Dispose()
    {
    }
}
