using System;
using System.Diagnostics;
using System.IO;
using System.Threading;

namespace UavConsole;

/// <summary>
/// Reads the keys of a terminal by a thread of its own, which a program that ends does not wait for. Where standard
/// input is no terminal nothing is read.
/// </summary>
internal static class KeyReader
{
    /// <summary>Whether there is a terminal to read from.</summary>
    public static bool IsPossible => !Console.IsInputRedirected;

    public static void Start(OperatorKeys keys, Stopwatch clock)
        => new Thread(() => Read(keys, clock)) { IsBackground = true, Name = "keys" }.Start();

    private static void Read(OperatorKeys keys, Stopwatch clock)
    {
        const ConsoleModifiers Commands = ConsoleModifiers.Control | ConsoleModifiers.Alt;
        try
        {
            while (true)
            {
                ConsoleKeyInfo key = Console.ReadKey(intercept: true);

                // Also what has no effect: it makes what comes with it a burst.
                keys.Press((key.Modifiers & Commands) == 0 ? key.KeyChar : '\0', clock.Elapsed);
            }
        }
        catch (Exception e) when (e is InvalidOperationException or IOException)
        {
            // The terminal has closed: there are no keys any more. The flight is not theirs to end.
            keys.Close();
        }
    }
}
