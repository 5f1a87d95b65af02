using System;
using System.Collections.Generic;
using System.Globalization;
using System.Threading.Tasks;
using Microsoft.AspNetCore.Http;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.State;

namespace Rabit.Uav.Web.Serving;

/// <summary>Takes the operator's commands: one POST each, with the token in its header.</summary>
internal sealed class CommandEndpoint(
    LivePageToken? token, Func<IReadOnlyList<LiveVehicle>> vehicles, CommandLimit limit, PageCounters counters)
{
    private const string Scheme = "Bearer ";
    private const int MaxBodyBytes = 4096;

    public async Task HandleAsync(HttpContext context)
    {
        (int status, string answer) = await TakeAsync(context).ConfigureAwait(false);
        if (status == StatusCodes.Status202Accepted)
            counters.Count((ref LivePageCounters c) => c.Commands++);
        else
            counters.Count((ref LivePageCounters c) => c.CommandsRefused++);
        context.Response.StatusCode = status;
        context.Response.ContentType = "text/plain; charset=utf-8";
        await context.Response.WriteAsync(answer, context.RequestAborted).ConfigureAwait(false);
    }

    private async Task<(int Status, string Answer)> TakeAsync(HttpContext context)
    {
        if (token is null)
            return (StatusCodes.Status403Forbidden, "This page has no token: it is read-only.");
        if (!HasToken(context.Request))
            return (StatusCodes.Status401Unauthorized, "The token is wrong.");
        if (!RequestGate.IsOriginOurs(context.Request))
            return (StatusCodes.Status403Forbidden, "Another page sent this.");
        if (!context.Request.HasJsonContentType())
            return (StatusCodes.Status415UnsupportedMediaType, "A command is JSON.");

        // Before the body is read, so that a flood costs little.
        if (!limit.TryTake())
            return (StatusCodes.Status429TooManyRequests, "No more than five commands a second.");
        if (await ReadBodyAsync(context).ConfigureAwait(false) is not { } body)
            return (StatusCodes.Status413PayloadTooLarge, "A command is shorter.");
        string by = "browser at " + context.Connection.RemoteIpAddress;
        if (CommandReader.Read(body, by, out int vehicle, out OperatorRequest? request) is { } fault)
            return (StatusCodes.Status400BadRequest, fault);
        IReadOnlyList<LiveVehicle> all = vehicles();
        if (vehicle >= all.Count || !all[vehicle].Commands.IsOpen)
            return (StatusCodes.Status404NotFound, string.Create(
                CultureInfo.InvariantCulture, $"vehicle {vehicle} takes no commands."));
        all[vehicle].Commands.Give(request!);
        return (StatusCodes.Status202Accepted, request!.Name);
    }

    private bool HasToken(HttpRequest request)
        => request.Headers.Authorization is [{ } header] && header.StartsWith(Scheme, StringComparison.Ordinal)
            && token!.IsEqual(header.AsSpan(Scheme.Length));

    // Null where it is longer than any command.
    private static async Task<ReadOnlyMemory<byte>?> ReadBodyAsync(HttpContext context)
    {
        var body = new byte[MaxBodyBytes + 1];
        int length = 0;
        while (length < body.Length)
        {
            int read = await context.Request.Body.ReadAsync(body.AsMemory(length), context.RequestAborted)
                .ConfigureAwait(false);
            if (read == 0)
                return body.AsMemory(0, length);
            length += read;
        }

        return null;
    }
}
