// Runs commands of the program one after the other, and tells what each gave. Who wants no more of them ends the worker.
import create from 'cnrg-module';
import {run} from './program.mjs';

onmessage = async ({data: {compiled, commands}}) => {
  for (const {words, files, input, id} of commands) {
    const begin = performance.now();
    const done = await run(create, compiled, words, files, input);
    postMessage({id, ...done, seconds: (performance.now() - begin) / 1000});
  }
  postMessage({ended: true});
};
