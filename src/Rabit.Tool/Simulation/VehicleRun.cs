using System;
using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Simulation;
using Rabit.Vision;

namespace Rabit.Tool.Simulation;

/// <summary>
/// The main job: opens the link, runs the vehicle in real time, says when something changes, and writes the truth at
/// the end.
/// </summary>
internal static class VehicleRun
{
    private static readonly TimeSpan ShowEvery = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan PollUntilWired = TimeSpan.FromMilliseconds(5);

    /// <returns>The exit code.</returns>
    /// <exception cref="ToolException">A link or a file cannot be opened, read or written.</exception>
    public static int Run(VehicleOptions options, InvocationConfiguration console)
    {
        try
        {
            CheckTruthOverwrites("--mission", options.MissionFile, options);
            CheckTruthOverwrites("--sign-key", options.SignKeyFile, options);
            if (options.MissionFile is not null)
                MissionWorld.Read(options.MissionFile, options.World);
            SimulatedWorld world = CreateWorld(options);
            using TruthOutput? truthFile = TruthOutput.Open(options.TruthFile);
            CameraFolder? folder = options.CameraFolder is { } path
                ? CameraFolder.Create(path, world.CameraModel, world.CameraMount)
                : null;
            using MavlinkSigningKey? key = options.SignKeyFile is { } keyFile ? SigningKeyFile.Read(keyFile) : null;
            using IByteLink link = ReopeningLink.Open(options.Link);
            truthFile?.Write(world);
            int exitCode = Fly(world.CreateVehicle(link, key), world, folder, options, console);
            truthFile?.Write(world);
            return exitCode;
        }
        catch (Exception e)
            when (e is LinkException or PictureException or ArgumentException or PlatformNotSupportedException
                or IOException or UnauthorizedAccessException)
        {
            throw new ToolException(FirstLine(e), e);
        }
    }

    // One of several is the same as in a simulated group: the targets are those of all, start and errors its own.
    private static SimulatedWorld CreateWorld(VehicleOptions options)
    {
        if (options.GroupSize == 1)
            return new SimulatedWorld(options.World);
        int number = options.World.SystemId;
        if (number > options.GroupSize)
            throw new ArgumentException(
                $"--group {options.GroupSize}: the vehicles have the system ids 1 to {options.GroupSize}, "
                    + $"not {number}.",
                nameof(options));
        var group = new SimulatedGroup(
            new SimulatedGroupOptions { Vehicles = options.GroupSize, World = options.World });
        return group.Vehicles[number - 1].World;
    }

    private static int Fly(
        RabitManager vehicle, SimulatedWorld world, CameraFolder? folder, VehicleOptions options,
        InvocationConfiguration console)
    {
        // The reactor takes the first Ctrl-C while it runs; one that comes before that stops it once it runs. Neither a
        // second one nor one that comes late may cut the truth off.
        bool isInterrupted = false;
        Console.CancelKeyPress += (_, e) =>
        {
            e.Cancel = true;
            Volatile.Write(ref isInterrupted, true);
        };
        var reactorOptions = new ReactorOptions { Log = entry => WriteNews(entry, console.Error) };
        var reactor = new RabitReactor(reactorOptions) { vehicle };
        if (folder is not null)
            reactor.Add(new CameraRecorderManager(world.CreateCamera(), new PictureFolderWriter(folder)));
        var line = new StatusLine(console.Output, console.Error);
        Task<ReactorResult> run = reactor.RunAsync();

        // Once it is wired the reactor takes signals. On Mono nothing else does where the output is no terminal.
        while (!reactor.IsWired && !run.Wait(PollUntilWired))
        {
        }

        line.Write($"simulated vehicle, seed {options.World.Seed}, on {options.Link}; Ctrl-C ends it");
        while (!run.Wait(ShowEvery))
        {
            if (Volatile.Read(ref isInterrupted))
                reactor.Stop("Ctrl-C");
            line.Show(reactor.Now, world.Truth);
        }

        line.Show(reactor.Now, world.Truth);
        ReactorResult result = run.GetAwaiter().GetResult();
        if (result.ExitCode != ToolExitCode.Done)
        {
            console.Error.WriteLine(result);
            return result.ExitCode;
        }

        return line.HasFailed ? ToolExitCode.BadInput : ToolExitCode.Done;
    }

    // What is read is never written to.
    private static void CheckTruthOverwrites(string option, string? file, VehicleOptions options)
    {
        if (file is { Length: > 0 } && options.TruthFile is { Length: > 0 } truth
            && string.Equals(Path.GetFullPath(file), Path.GetFullPath(truth), StringComparison.Ordinal))
            throw new ArgumentException($"{option} and --truth-out are the same file {truth}.", nameof(options));
    }

    private static void WriteNews(RabitLogEntry entry, TextWriter errors)
    {
        if (entry.Kind is RabitLogKind.Fault or RabitLogKind.Manager)
            errors.WriteLine(entry);
    }

    // ArgumentException adds the parameter's name on a line or in brackets; a person needs the sentence alone.
    private static string FirstLine(Exception e)
    {
        string text = e.Message;
        int end = text.IndexOf(" (Parameter '", StringComparison.Ordinal);
        if (end < 0)
            end = text.IndexOfAny(['\r', '\n']);
        return end < 0 ? text : text.Substring(0, end);
    }
}
